! Sorts parts by a code that a reader gives as a group of inputs, into one of four bins. Trays count their parts, and a
! full one is changed by the operator.
MODULE SortMain
  VAR bool is_running:=TRUE;
  VAR num missed:=0;
  VAR intnum door_opened;
  VAR intnum heartbeat;
  VAR num beats:=0;

  PROC main()
    VAR num code;
    start_up;
    WHILE is_running DO
      code:=next_code();
      TEST code
      CASE 0:
        Incr missed;
      CASE 1,2,3,4:
        sort_into code;
      CASE 15:
        is_running:=FALSE;
      DEFAULT:
        TPWrite "unknown code "\Num:=code;
        reject;
      ENDTEST
    ENDWHILE
    show_bins;
    MoveJ sort_home,v500,fine,picker;
  ENDPROC

  LOCAL PROC start_up()
    VAR num answer;
    IDelete door_opened;
    IDelete heartbeat;
    CONNECT door_opened WITH on_door;
    ISignalDI di_door,1,door_opened;
    CONNECT heartbeat WITH on_beat;
    ITimer 0.5,heartbeat;
    TPErase;
    TPReadFK answer,"keep the counts of the bins?","yes","no","","",""\MaxTime:=5;
    IF answer=2 clear_bins;
    SingArea\Off;
    MoveJ sort_home,v500,fine,picker;
  ERROR
    ! no answer: the counts are kept
    IF ERRNO=ERR_TP_MAXTIME TRYNEXT;
  ENDPROC

  ! 0 if no part came in time
  LOCAL FUNC num next_code()
    VAR bool none;
    VAR num code;
    Set do_feed;
    WaitDI di_part,1\MaxTime:=3\TimeFlag:=none;
    Reset do_feed;
    IF none RETURN 0;
    ! the reader needs a moment
    WaitTime 0.1;
    code:=gi_code;
    RETURN code;
  ENDFUNC

  LOCAL PROC sort_into(num bin)
    VAR robtarget goal;
    IF is_full(bin) change_tray bin;
    goal:=next_place(bin);
    take;
    MoveJ Offs(goal,0,0,100),v800,z30,picker;
    MoveL goal,v200,fine,picker;
    release;
    count_part bin;
    MoveL Offs(goal,0,0,100),v400,z30,picker;
  ENDPROC

  LOCAL PROC reject()
    take;
    MoveJ reject_place,v800,fine,picker;
    release;
  ENDPROC

  LOCAL PROC change_tray(num bin)
    VAR num answer;
  again:
    TPReadNum answer,"tray "+NumToStr(bin,0)+" is full: type its number when it is changed";
    IF answer<>bin GOTO again;
    empty_bin bin;
  ENDPROC

  LOCAL TRAP on_door
    StopMove;
    TPWrite "door open";
    WaitDI di_door,0;
    StartMove;
  ENDTRAP

  LOCAL TRAP on_beat
    Incr beats;
    InvertDO do_alive;
  ENDTRAP
ENDMODULE
