! Where the boxes are: sizes in mm, places in the work object of the pallet.
MODULE PalletLayout
  RECORD size
    num x;
    num y;
    num z;
  ENDRECORD

  CONST num layers:=4;
  CONST num columns:=3;
  CONST num rows:=2;
  CONST num places_in_layer:=columns*rows;
  CONST num gap:=2;
  CONST num clearance:=150;
  CONST size box_size:=[120,80,60];

  CONST robtarget home:=[[420,-120,450],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pick:=[[350,300,120],[0,0.707106781,0.707106781,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget corner:=[[0,0,0],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS wobjdata pallet:=[FALSE,TRUE,"",[[300,-350,50],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  ! offsets of single places, found by trying, in mm
  PERS pos fine_tuning{4,6}:=[[[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]],
    [[0,0,0.5],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0.5]],
    [[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]],
    [[0,0,0.5],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0.5]]];

  FUNC robtarget place_of(num layer,num place)
    VAR num column;
    VAR num row;
    VAR robtarget goal;
    VAR pos shift;
    column:=(place-1) MOD columns;
    row:=(place-1) DIV columns;
    IF is_turned(layer) THEN
      goal:=RelTool(Offs(corner,(row+0.5)*(box_size.x+gap),(column+0.5)*(box_size.y+gap),0),0,0,0\Rz:=90);
    ELSE
      goal:=Offs(corner,(column+0.5)*(box_size.x+gap),(row+0.5)*(box_size.y+gap),0);
    ENDIF
    shift:=fine_tuning{layer,place};
    goal.trans:=goal.trans+shift+[0,0,layer*box_size.z];
    RETURN goal;
  ENDFUNC

  FUNC bool is_turned(num layer)
    RETURN layer MOD 2=0;
  ENDFUNC
ENDMODULE
