#include "check_provocations.h"

#include <algorithm>
#include <array>

namespace cobot_command::rapid {

namespace {

constexpr Dialect kS4c = Dialect::S4c;

bool beginsWith(const std::string& text, std::string_view word) {
  return text.compare(0, word.size(), word) == 0;
}

bool isOfModule(const std::string& text) {
  constexpr std::array<std::string_view, 9> kWords{"VAR ",   "PERS ", "CONST ", "RECORD ", "ALIAS ",
                                                   "LOCAL ", "PROC ", "FUNC ",  "TRAP "};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return beginsWith(text, word); });
}

constexpr std::string_view kBefore =
    "MODULE m\n"
    "VAR num a; VAR num i; VAR bool b; VAR string s; VAR pos p; VAR orient q; VAR clock c; VAR num list{3};\n"
    "VAR intnum iv; PERS num kept:=1; PERS tooldata "
    "tools{1}:=[[TRUE,[[0,0,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]]];\n"
    "CONST robtarget t:=[[0,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n";
constexpr std::string_view kAfter =
    "FUNC num f(num x) RETURN x; ENDFUNC\n"
    "PROC go(num x\\num y|switch z) ENDPROC\n"
    "PROC matrix(num x{*,*}) ENDPROC\n"
    "TRAP t1 ENDTRAP\n"
    "ENDMODULE\n";

}  // namespace

FramedText frame(const std::string& text) {
  if (beginsWith(text, "MODULE")) return {text, 1};
  const std::string before(kBefore);
  const std::string after(kAfter);
  if (isOfModule(text)) return {before + text + "\nPROC main()\nENDPROC\n" + after, 5};
  return {before + "PROC main()\n" + text + "\nENDPROC\n" + after, 6};
}

CheckOptions frameOptions() {
  CheckOptions options;
  for (const SignalType type : {SignalType::Di, SignalType::Do}) {
    Signal signal;
    signal.name = std::string(toString(type)) + "1";
    signal.folded = signal.name;
    signal.type = type;
    signal.is_virtual = true;
    signal.indices = {0};
    options.signals.push_back(std::move(signal));
  }
  options.skipped = {"SoftDeact"};
  return options;
}

const std::vector<CheckProvocation>& checkProvocations() {
  static const std::vector<CheckProvocation> rows{
      {"E301", "VAR num twice; VAR num twice;", 1, 24, "'twice' is declared already at 5:9"},
      {"E301", "PROC two(num x,num x) ENDPROC", 1, 20, "'x' is declared already at 5:14"},
      {"E301", "RECORD r num x; ENDRECORD VAR num r;", 1, 35, "'r' is declared already at 5:8"},
      {"E302", "MODULE main PROC main() ENDPROC ENDMODULE", 1, 8,
       "module 'main' has the name of another module, routine or data"},
      {"E303", "MODULE m ENDMODULE", 1, 1, "no main() in the program"},
      {"E303", "PROC main() ENDPROC", 2, 6, "a second main() in the program"},
      {"E304", "MODULE m LOCAL PROC main() ENDPROC ENDMODULE", 1, 21, "main is global and has no parameters"},
      {"E304", "MODULE m PROC main(num x) ENDPROC ENDMODULE", 1, 15, "main is global and has no parameters"},
      {"E305", "PROC two() PERS num x:=1; ENDPROC", 1, 12, "PERS is for modules"},
      {"E307", "VAR num x:=a;", 1, 12, "the initial value must be constant"},
      {"E307", "PERS num x:=1+1;", 1, 13, "the initial value must be a literal"},
      {"E307", "CONST num x:=f(1);", 1, 14, "the initial value must be constant"},
      {"E307", "CONST num x:=Sqrt(4);", 1, 14, "the initial value must be constant", kS4c},
      {"E308", "VAR num x{0};", 1, 11, "a dimension is a whole number from 1"},
      {"E308", "VAR num x{a};", 1, 11, "a dimension is a whole number from 1"},
      {"E309", "VAR num x{1,2,3,4};", 1, 17, "three dimensions at the most"},
      {"E309", "PROC two(num x{*,*,*,*}) ENDPROC", 1, 22, "three dimensions at the most"},
      {"E310", "VAR nume x;", 1, 5, "'nume' is no data type; did you mean num?"},
      {"E312", "VAR clock x:=1;", 1, 14, "clock has no values"},
      {"E313", "VAR signaldo x;", 1, 5, "signaldo is never declared"},
      {"E313", "PERS clock x:=1;", 1, 6, "clock is never PERS"},
      {"E314", "PROC two(switch x) ENDPROC", 1, 10, "switch is for optional parameters"},
      {"E314", "VAR switch x;", 1, 5, "switch is for optional parameters"},
      {"E315", "RECORD r num x; num x; ENDRECORD", 1, 21, "component 'x' is there already"},
      {"E316", "RECORD r r x; ENDRECORD", 1, 10, "'r' contains itself"},
      {"E316", "ALIAS y x; ALIAS x y;", 1, 20, "'y' contains itself"},
      {"E317", "FUNC clock two() RAISE 1; ENDFUNC", 1, 6, "a function cannot return clock"},
      {"E318", "l: l:", 1, 4, "label 'l' is there already, or is data here"},
      {"W319", "PROC two() VAR num Reset; ENDPROC", 1, 20, "'Reset' hides the predefined one"},
      {"W322", "VAR confdata x:=[0,0,0];", 1, 17, "three-part confdata, cfx is 0"},
      {"E325", "VAR num x{1001,1000};", 1, 16, "an array has at most 1000000 elements"},
      {"E326", "VAR string x{1000000};", 1, 12, "the data of a program take at most 64 MiB"},
      {"E401", "a:=zz;", 1, 4, "'zz' is not declared"},
      {"E401", "a:=lits{1};", 1, 4, "'lits' is not declared; did you mean list?"},
      {"E402", "a:=go;", 1, 4, "'go' is a procedure, not a value"},
      {"E402", "a:=go(1);", 1, 4, "'go' is a procedure, not a function"},
      {"E402", "a;", 1, 1, "'a' is a variable, not a procedure"},
      {"E402", "a:=num;", 1, 4, "'num' is a data type, not a value"},
      {"E403", "s:=s+1;", 1, 5, "+ is not defined for string num"},
      {"E403", "b:=NOT a;", 1, 4, "NOT is not defined for num"},
      {"E403", "p:=p/2;", 1, 5, "/ is not defined for pos num", kS4c},
      {"E404", "s:=3;", 1, 4, "expected string, found num"},
      {"E404", "a:=list;", 1, 4, "expected num, found num{3}"},
      {"E404", "a:=[1];", 1, 4, "expected num, found an aggregate"},
      {"E405", "IF 1 THEN ENDIF", 1, 4, "a condition is bool, this is num"},
      {"E406", "b:=[1]=[1];", 1, 4, "nothing tells the type of this aggregate"},
      {"E407", "p:=[1,2];", 1, 4, "pos has 3 parts, this has 2"},
      {"E408", "a:=p.w;", 1, 6, "pos has no component 'w'"},
      {"E409", "a:=a{1};", 1, 5, "'a' has 0 dimensions, 1 are given"},
      {"E410", "a:=list{4};", 1, 9, "index 4 is outside 1 to 3"},
      {"E411", "v100:=v200;", 1, 1, "'v100' cannot be changed: CONST"},
      {"E411", "FOR n FROM 1 TO 2 DO n:=1; ENDFOR", 1, 22, "'n' cannot be changed: loop counter"},
      {"E411", "di1:=1;", 1, 1, "'di1' cannot be changed: read-only"},
      {"E411", "go:=1;", 1, 1, "'go' cannot be changed: routine"},
      {"E411", "Incr ERRNO;", 1, 6, "'ERRNO' cannot be changed: read-only"},
      {"E412", "c:=c;", 1, 1, "clock has no values"},
      {"E412", "b:=c=c;", 1, 5, "clock has no values"},
      {"E412", "TEST c ENDTEST", 1, 6, "clock has no values"},
      {"E412", "PROC two(clock x) ENDPROC", 1, 16, "clock has no values"},
      {"W413", "a:=1/0;", 1, 5, "division by zero"},
      {"W415", "a:=1.5 DIV 2;", 1, 8, "DIV of a number that is not whole"},
      {"W416", "q:=[0.924,0,0.37,0];", 1, 4, "quaternion of length 0.995327 is taken as 1"},
      {"E417", "q:=[1,1,0,0];", 1, 4, "quaternion of length 1.41421 is none"},
      {"E419", "Set lamp;", 1, 5, "signal 'lamp' is not configured"},
      {"E419", "Set doo1;", 1, 5, "signal 'doo1' is not configured; did you mean do1?"},
      {"W420", "b:=NOT b AND b;", 1, 4, "NOT stands for the whole AND chain"},
      {"E421", "s:=\"5 \xE2\x82\xAC\";", 1, 7, "'\xE2\x82\xAC' is no character of ISO 8859-1"},
      {"E501", "MovL t,v100,fine,tool0;", 1, 1, "there is no procedure 'MovL'; did you mean MoveL?"},
      {"E502", "IndAMove a;", 1, 1,
       "IndAMove is known but not supported: the arm has six axes and no others; leave external axes 9E9, or "
       "--skip"},
      {"E502", "StorePath;", 1, 1,
       "StorePath is known but not supported: not built yet; --skip passes over a call of an instruction"},
      {"E502", "VAR welddata x;", 1, 5,
       "welddata is known but not supported: process packages are modules in RAPID, not built yet; TriggL "
       "and "
       "signals"},
      {"E502", "MoveL t,v100,fine,tool0\\Corr;", 1, 25,
       "Corr is known but not supported: no motion is corrected while it runs; PDispSet between moves"},
      {"E503", "MoveL t,v100,fine;", 1, 18, "argument Tool is missing"},
      {"E504", "go 1,2;", 1, 6, "one argument too many"},
      {"E505", "go 1\\Q:=1;", 1, 6, "no optional argument '\\Q'"},
      {"E505", "MoveL t,v100,fine,tool0\\WOb:=wobj0;", 1, 25,
       "no optional argument '\\WOb'; did you mean WObj?"},
      {"E506", "go\\y:=1,1\\y:=2;", 1, 11, "'\\y' twice or out of order"},
      {"E507", "go 1\\y:=1\\z;", 1, 11, "'\\z' excludes '\\y'"},
      {"E508", "go 1\\z:=TRUE;", 1, 6, "'\\z' is a switch and takes no value"},
      {"E509", "go 1\\y;", 1, 6, "'\\y' needs a value"},
      {"E510", "Incr 5;", 1, 6, "Name takes a variable or whole persistent"},
      {"E510", "ClkReset c+c;", 1, 10, "Clock takes a variable"},
      {"E510", "MoveL t,v100,fine,tools{1};", 1, 19, "Tool takes a whole persistent"},
      {"E510", "b:=IsVar(1);", 1, 10, "DatObj takes a name"},
      {"E511", "go Y:=1;", 1, 4, "the argument here is x, not Y"},
      {"E512", "go 1\\y?a;", 1, 8, "'a' is no optional parameter here"},
      {"E513", "matrix list;", 1, 8, "x takes 2 dimensions, this has 1"},
      {"E515", "t1;", 1, 1, "a trap is not called"},
      {"E516", "f 4;", 1, 1, "'f' is a function"},
      {"W524", "SoftDeact;", 1, 1, "SoftDeact is passed over, as asked"},
      {"E601", "GOTO l;", 1, 6, "there is no label 'l'"},
      {"E602", "IF b GOTO l; WHILE b DO l: ENDWHILE", 1, 11, "label 'l' is inside what this GOTO is not in"},
      {"E603", "RETURN 5;", 1, 8, "only a function returns a value"},
      {"E604", "FUNC num two() RETURN; ENDFUNC", 1, 16, "a function returns a value"},
      {"W605", "FUNC num two() ENDFUNC", 1, 10, "the end of 'two' can be reached without RETURN"},
      {"E606", "RETRY;", 1, 1, "RETRY is for error handlers"},
      {"E606", "TRYNEXT;", 1, 1, "TRYNEXT is for error handlers"},
      {"E607", "ERROR RAISE 5;", 1, 13, "in a handler RAISE has no number"},
      {"E608", "RAISE;", 1, 1, "outside of a handler RAISE needs a number"},
      {"W609", "RAISE 91;", 1, 7, "91 is neither 1 to 90 nor booked"},
      {"W609", "RAISE ERR_DIVZERO;", 1, 7, "ERR_DIVZERO is neither 1 to 90 nor booked"},
      {"E610", "FOR n FROM 1 TO 2 STEP 0 DO ENDFOR", 1, 24, "STEP 0 never ends"},
      {"W610", "FOR n FROM 1 TO 2 STEP 0.1 DO ENDFOR", 1, 24, "numbers that are not whole may miss the end"},
      {"W611", "EXIT; a:=1;", 1, 7, "nothing gets here"},
      {"W612", "PROC two() VAR intnum x; CONNECT x WITH t1; ENDPROC", 1, 34,
       "this interrupt number ends with the routine"},
      {"E613", "CONNECT iv WITH go;", 1, 17, "'go' is no trap"},
      {"W614", "TEST a CASE 1: CASE 1: ENDTEST", 1, 21, "the value stands in an earlier CASE"},
      {"E801", "MoveL t,v100,z0,tool0;", 1, 14, "z0 is not in s4c", kS4c},
  };
  return rows;
}

}  // namespace cobot_command::rapid
