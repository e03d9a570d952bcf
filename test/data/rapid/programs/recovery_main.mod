! A machine is loaded and unloaded. Everything that may fail has a way back: errors are raised with numbers of their own,
! passed up where they cannot be handled, and counted.
MODULE RecoveryMain
  VAR errnum ERR_NO_PART:=-1;
  VAR errnum ERR_MACHINE:=-1;
  VAR num tries;
  PERS num parts_made:=0;
  VAR string mode:="normal";

  PROC main()
    book;
    reset_all;
    FOR cycle FROM 1 TO 5 DO
      mode:="normal";
      one_part cycle;
      IF mode="stop" GOTO finished;
    ENDFOR
  finished:
    show_statistics;
    IF parts_made>=1000 THEN
      parts_made:=0;
      TPWrite "counter was set back";
    ENDIF
  ERROR
    ! whatever is left: say what it was, and end
    note ERRNO;
    TPWrite "gave up: "+name_of(ERRNO);
    all_off;
    RETURN;
  ENDPROC

  LOCAL PROC book()
    IF ERR_NO_PART<0 THEN
      BookErrNo ERR_NO_PART;
      BookErrNo ERR_MACHINE;
    ENDIF
  ENDPROC

  LOCAL PROC one_part(num cycle)
    tries:=0;
    load_part;
    start_machine\Limit:=4;
    unload_part;
    Incr parts_made;
    TPWrite "part "+NumToStr(cycle,0)+" is done";
  ERROR
    note ERRNO;
    TEST ERRNO
    CASE ERR_NO_PART:
      Incr tries;
      IF tries<3 RETRY;
      mode:="stop";
      RETURN;
    CASE ERR_MACHINE:
      %"recover_"+mode%;
      mode:="careful";
      TRYNEXT;
    CASE ERR_WAIT_MAXTIME:
      IF operator_retries() RETRY;
      mode:="stop";
      RETURN;
    DEFAULT:
      RAISE;
    ENDTEST
  ENDPROC

  LOCAL PROC load_part()
    VAR bool none;
    WaitDI di_part_there,1\MaxTime:=2\TimeFlag:=none;
    IF none RAISE ERR_NO_PART;
    MoveJ Offs(pick_place,0,0,100),v800,z20,clamp;
    MoveL pick_place,v200,fine,clamp;
    SetDO do_clamp,high;
    WaitTime 0.2;
    MoveL Offs(pick_place,0,0,100),v400,z20,clamp;
    MoveJ before_machine,v800,fine,clamp;
    WaitDI di_machine_open,1\MaxTime:=10;
    MoveL in_machine,v200,fine,clamp;
    SetDO do_clamp,low;
    MoveL before_machine,v400,fine,clamp;
  ERROR
    ! both are the caller's
    RAISE;
  ENDPROC

  LOCAL PROC unload_part()
    MoveL in_machine,v200,fine,clamp;
    Set do_clamp;
    WaitTime 0.2;
    MoveL before_machine,v400,z10,clamp;
    MoveJ put_place,v800,fine,clamp;
    Reset do_clamp;
  ENDPROC

  PROC recover_normal()
    TPWrite "the machine is reset";
    PulseDO\PLength:=0.5,do_machine_reset;
    WaitTime 1;
  ENDPROC

  PROC recover_careful()
    TPWrite "the machine is reset, and waited for";
    PulseDO\PLength:=1,do_machine_reset;
    WaitUntil di_machine_open=1\MaxTime:=20;
  ERROR
    IF ERRNO=ERR_WAIT_MAXTIME TRYNEXT;
  ENDPROC
ENDMODULE
