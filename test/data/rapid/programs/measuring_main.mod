! Measures the height of a part in a grid with an analog distance sensor, and shifts the work object by what it found.
! A touch input stops the robot if the part is much too high.
MODULE MeasureMain
  CONST num points_x:=4;
  CONST num points_y:=3;
  VAR num heights{4,3};
  VAR intnum touched;
  VAR bool was_touched:=FALSE;

  PROC main()
    VAR num mean;
    VAR num spread;
    VAR num slope_x;
    arm_sensor;
    measure_grid;
    IF was_touched THEN
      TPWrite "touched: nothing was changed";
      RETURN;
    ENDIF
    statistics heights,mean,spread;
    slope_x:=slope(heights);
    TPWrite "mean: "+NumToStr(mean,3)+" spread: "+NumToStr(spread,3);
    TPWrite "slope: "\Num:=Round(slope_x\Dec:=4);
    IF spread>limit_spread THEN
      ErrWrite "part is bad","spread "+NumToStr(spread,2)\RL2:="limit "+NumToStr(limit_spread,2);
      PulseDO do_bad;
    ELSE
      correct mean,slope_x;
      PulseDO do_good;
    ENDIF
    check_corner;
  ENDPROC

  LOCAL PROC arm_sensor()
    IDelete touched;
    CONNECT touched WITH on_touch;
    ISignalDI\Single,di_touch,1,touched;
    was_touched:=FALSE;
  ENDPROC

  LOCAL PROC measure_grid()
    VAR robtarget above;
    VAR speeddata measuring:=[40,30,5000,1000];
    FOR y FROM 1 TO points_y DO
      FOR x FROM 1 TO points_x DO
        above:=Offs(grid_start,(x-1)*grid_step,(y-1)*grid_step,0);
        MoveL above,measuring,fine,sensor\WObj:=part_frame;
        IF was_touched RETURN;
        heights{x,y}:=distance_at();
      ENDFOR
    ENDFOR
    MoveL Offs(grid_start,0,0,100),v200,fine,sensor\WObj:=part_frame;
  ENDPROC

  ! with another start the same path, seen from the corrected frame
  LOCAL PROC check_corner()
    VAR robtarget before;
    VAR robtarget after;
    MoveJ Offs(grid_start,0,0,20),v200,fine,sensor\WObj:=part_frame;
    before:=CRobT(\Tool:=sensor\WObj:=wobj0);
    PDispSet [[0,0,5],[1,0,0,0]];
    MoveL Offs(grid_start,0,0,20),v200,fine,sensor\WObj:=part_frame;
    after:=CRobT(\Tool:=sensor\WObj:=wobj0);
    PDispOff;
    TPWrite "moved by "\Num:=Round(Distance(before.trans,after.trans)\Dec:=3);
  ENDPROC

  LOCAL TRAP on_touch
    StopMove;
    was_touched:=TRUE;
    Set do_bad;
    WaitDI di_touch,0;
    Reset do_bad;
    StartMove;
  ENDTRAP
ENDMODULE
