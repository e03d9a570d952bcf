! The rack of the tools. A slot is entered from above, and left to the front.
MODULE ToolRack
  CONST num slots:=3;
  LOCAL CONST robtarget first_slot:=[[250,-380,200],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  LOCAL CONST num slot_pitch:=90;
  LOCAL PERS num in_hand:=0;
  PERS tooldata current_tool:=[TRUE,[[0,0,0],[1,0,0,0]],[0.5,[0,0,20],[1,0,0,0],0,0,0]];
  PERS tooldata changer:=[TRUE,[[0,0,40],[1,0,0,0]],[0.5,[0,0,20],[1,0,0,0],0,0,0]];
  LOCAL CONST tooldata tools{3}:=[
    [TRUE,[[0,0,180],[1,0,0,0]],[2.1,[0,0,90],[1,0,0,0],0.004,0.004,0.001]],
    [TRUE,[[0,25,150],[0.965925826,0,0,0.258819045]],[1.7,[0,10,80],[1,0,0,0],0,0,0]],
    [TRUE,[[0,0,120],[1,0,0,0]],[0.9,[0,0,60],[1,0,0,0],0,0,0]]];
  PERS wobjdata plate:=[FALSE,TRUE,"",[[350,50,100],[1,0,0,0]],[[0,0,15],[1,0,0,0]]];
  LOCAL CONST pos holes{5}:=[[20,20,0],[20,60,0],[80,20,0],[80,60,0],[50,40,0]];

  PROC fetch(num tool)
    IF tool=in_hand RETURN;
    IF in_hand>0 put_back;
    IF slot_input(tool)=0 THEN
      TPWrite "slot is empty: "\Num:=tool;
      WaitUntil slot_input(tool)=1\MaxTime:=60;
    ENDIF
    MoveJ Offs(slot_target(tool),0,0,80),v500,z20,changer;
    MoveL slot_target(tool),v50,fine,changer;
    lock;
    MoveL Offs(slot_target(tool),120,0,0),v100,fine,changer;
    in_hand:=tool;
    current_tool:=tools{tool};
  ENDPROC

  PROC put_back()
    IF in_hand=0 RETURN;
    MoveJ Offs(slot_target(in_hand),120,0,0),v500,z20,changer;
    MoveL slot_target(in_hand),v50,fine,changer;
    unlock;
    MoveL Offs(slot_target(in_hand),0,0,80),v100,fine,changer;
    forget_tool;
  ENDPROC

  PROC forget_tool()
    in_hand:=0;
    current_tool:=tool0;
  ENDPROC

  FUNC num tool_in_hand()
    RETURN in_hand;
  ENDFUNC

  PROC check_rack()
    VAR num found;
    FOR slot FROM 1 TO slots DO
      IF slot_input(slot)=1 Incr found;
    ENDFOR
    IF in_hand>0 Incr found;
    IF found<slots ErrWrite\W,"tools missing","found "+NumToStr(found,0);
  ENDPROC

  FUNC num hole_count()
    RETURN Dim(holes,1);
  ENDFUNC

  FUNC robtarget hole_target(num hole)
    VAR robtarget goal:=[[0,0,0],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    goal.trans:=holes{hole};
    RETURN goal;
  ENDFUNC

  LOCAL FUNC robtarget slot_target(num slot)
    RETURN Offs(first_slot,0,(slot-1)*slot_pitch,0);
  ENDFUNC

  LOCAL FUNC num slot_input(num slot)
    TEST slot
    CASE 1:
      RETURN di_slot_1;
    CASE 2:
      RETURN di_slot_2;
    CASE 3:
      RETURN di_slot_3;
    ENDTEST
    RETURN 0;
  ENDFUNC

  LOCAL PROC lock()
    Set do_lock;
    WaitDI di_tool_locked,1\MaxTime:=2;
  ENDPROC

  LOCAL PROC unlock()
    Reset do_lock;
    WaitDI di_tool_locked,0\MaxTime:=2;
  ENDPROC
ENDMODULE
