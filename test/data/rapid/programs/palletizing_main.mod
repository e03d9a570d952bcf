%%%
  VERSION:1
  LANGUAGE:ENGLISH
%%%
! Takes boxes from a conveyor and stacks them on a pallet: layers of three by two boxes, every second layer turned.
! The layout and the gripper are modules of their own.
MODULE PalletMain
  VAR num layer:=1;
  VAR num place:=1;
  VAR clock shift;
  PERS num boxes_done:=0;
  PERS bool pallet_full:=FALSE;
  VAR intnum pallet_taken;

  PROC main()
    prepare;
    WHILE NOT pallet_full DO
      WaitUntil di_box_ready=1 OR di_stop=1;
      IF di_stop=1 THEN
        TPWrite "stopped by the operator";
        park;
        RETURN;
      ENDIF
      move_one_box;
      next_place;
    ENDWHILE
    report;
    park;
  ENDPROC

  LOCAL PROC prepare()
    ConfJ\Off;
    ConfL\Off;
    AccSet 60,80;
    VelSet 100,1500;
    IDelete pallet_taken;
    CONNECT pallet_taken WITH on_pallet_taken;
    ISignalDI di_pallet_there,0,pallet_taken;
    ClkReset shift;
    ClkStart shift;
    open_gripper;
    IF di_pallet_there=0 THEN
      TPWrite "put a pallet into place";
      WaitDI di_pallet_there,1;
    ENDIF
    GripLoad load0;
    MoveJ home,v500,z50,gripper;
  ENDPROC

  LOCAL PROC move_one_box()
    VAR robtarget goal;
    VAR num lift;
    ! the way over the pallet is higher than the stack
    lift:=clearance+(layer-1)*box_size.z;
    goal:=place_of(layer,place);
    fetch_box;
    MoveJ Offs(goal,0,0,lift),v800,z50,gripper\WObj:=pallet;
    MoveL Offs(goal,0,0,20),v300,z10,gripper\WObj:=pallet;
    MoveL goal,v50,fine,gripper\WObj:=pallet;
    open_gripper;
    GripLoad load0;
    MoveL Offs(goal,0,0,lift),v300,z50,gripper\WObj:=pallet;
    Incr boxes_done;
  ERROR
    IF ERRNO=ERR_GRIP_LOST THEN
      ! the box fell: take the next one, the place is still free
      TPWrite "box lost at place "\Num:=place;
      open_gripper;
      RETRY;
    ENDIF
    RAISE;
  ENDPROC

  LOCAL PROC next_place()
    Incr place;
    IF place<=places_in_layer RETURN;
    place:=1;
    Incr layer;
    IF layer>layers pallet_full:=TRUE;
  ENDPROC

  LOCAL PROC report()
    VAR num minutes;
    ClkStop shift;
    minutes:=Round(ClkRead(shift)/60\Dec:=1);
    TPWrite "boxes: "\Num:=boxes_done;
    TPWrite "minutes: "+NumToStr(minutes,1);
    SetGO go_count,boxes_done MOD 16;
    PulseDO\PLength:=0.5,do_pallet_full;
  ENDPROC

  LOCAL PROC park()
    MoveJ home,v500,fine,gripper;
    Reset do_vacuum;
  ENDPROC

  LOCAL TRAP on_pallet_taken
    ! a new pallet begins with its first place
    layer:=1;
    place:=1;
    pallet_full:=FALSE;
    ErrWrite\I,"pallet taken","counting begins again";
  ENDTRAP
ENDMODULE
