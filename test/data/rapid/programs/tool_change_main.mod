! Changes between three tools of a rack, and works with each of them. The tool in use is kept over restarts.
MODULE ToolChangeMain
  CONST num drill:=1;
  CONST num driver:=2;
  CONST num brush:=3;
  VAR errnum ERR_TOOL_LOST:=-1;
  VAR num holes_done;

  PROC main()
    IF ERR_TOOL_LOST<0 BookErrNo ERR_TOOL_LOST;
    check_rack;
    fetch drill;
    FOR hole FROM 1 TO hole_count() DO
      work_hole hole\Depth:=12\Feed:=20;
    ENDFOR
    fetch driver;
    FOR hole FROM hole_count() TO 1 STEP -1 DO
      work_hole hole\Depth:=8;
    ENDFOR
    fetch brush;
    clean;
    put_back;
    TPWrite "holes: "\Num:=holes_done;
  ERROR
    IF ERRNO=ERR_TOOL_LOST THEN
      TPWrite "the tool was lost";
      Stop;
      forget_tool;
      RETURN;
    ENDIF
  ENDPROC

  LOCAL PROC work_hole(num hole\num Depth\num Feed)
    VAR num depth_here:=10;
    VAR speeddata slow:=v50;
    IF Present(Depth) depth_here:=Depth;
    IF Present(Feed) slow.v_tcp:=Feed;
    approach_hole hole,30;
    require_tool;
    IF tool_in_hand()=drill THEN
      MoveL RelTool(hole_target(hole),0,0,depth_here),slow,fine,current_tool\WObj:=plate;
    ELSE
      ! one turn while the screw goes in
      MoveL RelTool(hole_target(hole),0,0,depth_here\Rz:=90),slow,fine,current_tool\WObj:=plate;
    ENDIF
    approach_hole hole,30;
    Incr holes_done;
  ENDPROC

  LOCAL PROC approach_hole(num hole,num height)
    MoveJ RelTool(hole_target(hole),0,0,-height),v500,z10,current_tool\WObj:=plate;
  ENDPROC

  LOCAL PROC require_tool()
    IF di_tool_locked=0 RAISE ERR_TOOL_LOST;
  ERROR
    RAISE;
  ENDPROC

  LOCAL PROC clean()
    VAR robtarget start;
    VAR robtarget across;
    start:=hole_target(1);
    across:=Offs(start,60,40,0);
    MoveJ Offs(start,0,0,20),v500,z10,current_tool\WObj:=plate;
    MoveL start,v100,fine,current_tool\WObj:=plate;
    MoveC Offs(start,60,0,0),across,v100,fine,current_tool\WObj:=plate;
    MoveL Offs(across,0,0,50),v200,fine,current_tool\WObj:=plate;
  ENDPROC
ENDMODULE
