! Four bins with room for six parts each, and the picker.
MODULE SortBins
  ALIAS num bin_number;
  RECORD bin
    string name;
    num parts;
    robtarget first;
  ENDRECORD

  CONST num room:=6;
  CONST num pitch:=45;
  CONST robtarget sort_home:=[[400,0,420],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget feeder:=[[380,-250,160],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget reject_place:=[[250,-350,250],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS tooldata picker:=[TRUE,[[0,0,110],[1,0,0,0]],[0.6,[0,0,50],[1,0,0,0],0,0,0]];
  PERS loaddata part:=[0.2,[0,0,20],[1,0,0,0],0,0,0];
  LOCAL PERS bin bins{4}:=[
    ["screws",0,[[300,150,140],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]],
    ["nuts",0,[[300,200,140],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]],
    ["washers",0,[[300,250,140],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]],
    ["pins",0,[[300,300,140],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]]];

  FUNC bool is_full(bin_number n)
    RETURN bins{n}.parts>=room;
  ENDFUNC

  FUNC robtarget next_place(bin_number n)
    RETURN Offs(bins{n}.first,bins{n}.parts*pitch,0,0);
  ENDFUNC

  PROC count_part(bin_number n)
    bins{n}.parts:=bins{n}.parts+1;
  ENDPROC

  PROC empty_bin(bin_number n)
    bins{n}.parts:=0;
  ENDPROC

  PROC clear_bins()
    FOR i FROM 1 TO Dim(bins,1) DO
      empty_bin i;
    ENDFOR
  ENDPROC

  PROC show_bins()
    VAR string line;
    VAR num total;
    FOR i FROM 1 TO Dim(bins,1) DO
      line:=bins{i}.name+": "+NumToStr(bins{i}.parts,0);
      TPWrite line;
      total:=total+bins{i}.parts;
    ENDFOR
    TPWrite "parts: "\Num:=total;
    SetAO ao_level,10*total/(room*Dim(bins,1));
  ENDPROC

  PROC take()
    MoveJ Offs(feeder,0,0,60),v800,z20,picker;
    MoveL feeder,v150,fine,picker;
    Set do_close;
    WaitTime\InPos,0.2;
    GripLoad part;
    MoveL Offs(feeder,0,0,60),v300,z20,picker;
  ENDPROC

  PROC release()
    Reset do_close;
    WaitTime 0.2;
    GripLoad load0;
  ENDPROC
ENDMODULE
