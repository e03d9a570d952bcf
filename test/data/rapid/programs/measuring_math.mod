! Statistics of a grid, and the frame of the part. Heights in mm.
MODULE MeasureMath
  CONST num grid_step:=25;
  CONST num limit_spread:=1.5;
  CONST robtarget grid_start:=[[10,10,60],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS tooldata sensor:=[TRUE,[[30,0,90],[1,0,0,0]],[0.4,[10,0,40],[1,0,0,0],0,0,0]];
  PERS wobjdata part_frame:=[FALSE,TRUE,"",[[380,-60,80],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  LOCAL CONST num volts_at_zero:=5;
  LOCAL CONST num mm_per_volt:=4;

  ! the mean of some readings
  FUNC num distance_at()
    VAR num sum;
    CONST num readings:=4;
    FOR i FROM 1 TO readings DO
      sum:=sum+(ai_distance-volts_at_zero)*mm_per_volt;
      WaitTime 0.02;
    ENDFOR
    RETURN sum/readings;
  ENDFUNC

  PROC statistics(num values{*,*},INOUT num mean,INOUT num spread)
    VAR num least:=9E9;
    VAR num most:=-9E9;
    VAR num sum;
    VAR num count;
    FOR i FROM 1 TO Dim(values,1) DO
      FOR j FROM 1 TO Dim(values,2) DO
        sum:=sum+values{i,j};
        IF values{i,j}<least least:=values{i,j};
        IF values{i,j}>most most:=values{i,j};
        Incr count;
      ENDFOR
    ENDFOR
    mean:=sum/count;
    spread:=most-least;
  ERROR
    IF ERRNO=ERR_DIVZERO THEN
      mean:=0;
      TRYNEXT;
    ENDIF
  ENDPROC

  ! height over way along the first index
  FUNC num slope(num values{*,*})
    VAR num first;
    VAR num last;
    VAR num columns;
    columns:=Dim(values,1);
    FOR j FROM 1 TO Dim(values,2) DO
      first:=first+values{1,j};
      last:=last+values{columns,j};
    ENDFOR
    RETURN (last-first)/Dim(values,2)/(grid_step*(columns-1));
  ENDFUNC

  PROC correct(num height,num slope_x)
    VAR pose change;
    VAR num angle;
    angle:=-ATan(slope_x);
    change:=[[0,0,height],OrientZYX(0,angle,0)];
    part_frame.oframe:=PoseMult(part_frame.oframe,change);
    TPWrite "frame: "+ValToStr(part_frame.oframe.trans);
    TPWrite "about y: "\Num:=Round(EulerZYX(\Y,part_frame.oframe.rot)\Dec:=3);
  ENDPROC
ENDMODULE
