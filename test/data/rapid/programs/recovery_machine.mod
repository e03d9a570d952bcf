! The machine, what is counted of its errors, and the places around it.
MODULE RecoveryMachine
  RECORD entry
    errnum number;
    num times;
  ENDRECORD

  CONST robtarget pick_place:=[[300,250,150],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget put_place:=[[300,-250,150],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget before_machine:=[[450,0,300],[0,0.707106781,0,0.707106781],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget in_machine:=[[560,0,300],[0,0.707106781,0,0.707106781],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS tooldata clamp:=[TRUE,[[0,0,130],[1,0,0,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];
  LOCAL CONST num size:=8;
  LOCAL VAR entry entries{8};
  LOCAL VAR num used:=0;

  PROC start_machine(\num Limit)
    VAR num seconds:=10;
    VAR bool is_late;
    IF Present(Limit) seconds:=Limit;
    IF di_machine_fault=1 RAISE ERR_MACHINE;
    SetDO\SDelay:=0.2,do_machine_start,1;
    WaitDI di_machine_done,1\MaxTime:=seconds\TimeFlag:=is_late;
    Reset do_machine_start;
    IF is_late AND di_machine_fault=1 RAISE ERR_MACHINE;
    IF is_late RAISE ERR_NO_PART;
  ERROR
    RAISE;
  ENDPROC

  PROC note(errnum number)
    VAR num at:=0;
    ! FROM 1 TO 0 counts down
    IF used>0 THEN
      FOR i FROM 1 TO used DO
        IF entries{i}.number=number at:=i;
      ENDFOR
    ENDIF
    IF at=0 THEN
      IF used=size RETURN;
      Incr used;
      at:=used;
      entries{at}:=[number,0];
    ENDIF
    Incr entries{at}.times;
  ENDPROC

  FUNC string name_of(errnum number)
    TEST number
    CASE ERR_WAIT_MAXTIME:
      RETURN "a signal did not come";
    CASE ERR_DIVZERO,ERR_OUTOFBND,ERR_NEGARG:
      RETURN "a fault of the program";
    DEFAULT:
      IF number=ERR_NO_PART RETURN "no part";
      IF number=ERR_MACHINE RETURN "the machine";
      RETURN "error "+NumToStr(number,0);
    ENDTEST
  ENDFUNC

  FUNC bool operator_retries()
    VAR num key;
    TPReadFK key,"the machine does not open","again","stop","","",""\MaxTime:=30;
    RETURN key=1;
  ERROR
    IF ERRNO=ERR_TP_MAXTIME RETURN FALSE;
  ENDFUNC

  PROC show_statistics()
    TPWrite "made: "\Num:=parts_made;
    FOR i FROM 1 TO used DO
      TPWrite name_of(entries{i}.number)+": "\Num:=entries{i}.times;
    ENDFOR
  ENDPROC

  PROC reset_all()
    used:=0;
    all_off;
    MoveJ before_machine,v500,fine,clamp;
  ENDPROC

  PROC all_off()
    Reset do_clamp;
    Reset do_machine_start;
  ENDPROC
ENDMODULE
