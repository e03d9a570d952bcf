! The vacuum gripper, with a sensor of the vacuum.
MODULE PalletGripper
  PERS tooldata gripper:=[TRUE,[[0,0,160],[1,0,0,0]],[1.4,[0,0,70],[1,0,0,0],0,0,0]];
  PERS loaddata box_load:=[1.1,[0,0,40],[1,0,0,0],0,0,0];
  CONST num vacuum_time:=1.5;
  VAR errnum ERR_GRIP_LOST:=-1;

  PROC fetch_box()
    VAR bool is_late;
    IF ERR_GRIP_LOST<0 BookErrNo ERR_GRIP_LOST;
    MoveJ Offs(pick,0,0,clearance),v800,z50,gripper;
    MoveL pick,v200,fine,gripper;
    Set do_vacuum;
    WaitDI di_vacuum_ok,1\MaxTime:=vacuum_time\TimeFlag:=is_late;
    IF is_late THEN
      Reset do_vacuum;
      RAISE ERR_GRIP_LOST;
    ENDIF
    GripLoad box_load;
    MoveL Offs(pick,0,0,clearance),v300,z20,gripper;
    IF DOutput(do_vacuum)=0 OR NOT TestDI(di_vacuum_ok) RAISE ERR_GRIP_LOST;
  ERROR
    RAISE;
  ENDPROC

  PROC open_gripper()
    Reset do_vacuum;
    WaitTime 0.3;
  ENDPROC
ENDMODULE
