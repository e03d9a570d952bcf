// The findings of checking: id and text of each. `{}` is replaced by what was found.
#pragma once

#include <array>

#include "cobot_command/rapid/source/finding_kinds.h"

namespace cobot_command::rapid::kinds {

// Declarations, and modules together.
inline constexpr FindingKind kDeclaredAlready{"E301", "'{}' is declared already at {}"};
inline constexpr FindingKind kModuleName{"E302",
                                         "module '{}' has the name of another module, routine or data"};
inline constexpr FindingKind kMain{"E303", "{} main() in the program"};
inline constexpr FindingKind kMainForm{"E304", "main is global and has no parameters"};
inline constexpr FindingKind kPersInRoutine{"E305", "PERS is for modules"};
inline constexpr FindingKind kInitialValue{"E307", "the initial value must be {}"};
inline constexpr FindingKind kDimension{"E308", "a dimension is a whole number from 1"};
inline constexpr FindingKind kThreeDimensions{"E309", "three dimensions at the most"};
inline constexpr FindingKind kNoDataType{"E310", "'{}' is no data type"};
inline constexpr FindingKind kNoInitialValue{"E312", "{} has no values"};
inline constexpr FindingKind kNeverDeclared{"E313", "{} is never {}"};
inline constexpr FindingKind kSwitchParameter{"E314", "switch is for optional parameters"};
inline constexpr FindingKind kComponentTwice{"E315", "component '{}' is there already"};
inline constexpr FindingKind kContainsItself{"E316", "'{}' contains itself"};
inline constexpr FindingKind kResultType{"E317", "a function cannot return {}"};
inline constexpr FindingKind kLabelTwice{"E318", "label '{}' is there already, or is data here"};
inline constexpr FindingKind kHidesPredefined{"W319", "'{}' hides the predefined one"};
inline constexpr FindingKind kThreePartConfdata{"W322", "three-part confdata, cfx is 0"};
inline constexpr FindingKind kLargeArray{"E325", "an array has at most {} elements"};
inline constexpr FindingKind kLargeProgram{"E326", "the data of a program take at most {} MiB"};
inline constexpr FindingKind kManyModules{"E327", "a program has at most {} modules"};

// Types and expressions.
inline constexpr FindingKind kNotDeclared{"E401", "'{}' is not declared"};
inline constexpr FindingKind kWrongKind{"E402", "'{}' is {}, not {}"};
inline constexpr FindingKind kNoOperation{"E403", "{} is not defined for {}"};
inline constexpr FindingKind kWrongType{"E404", "expected {}, found {}"};
inline constexpr FindingKind kNoCondition{"E405", "a condition is bool, this is {}"};
inline constexpr FindingKind kUntypedAggregate{"E406", "nothing tells the type of this aggregate"};
inline constexpr FindingKind kParts{"E407", "{} has {} parts, this has {}"};
inline constexpr FindingKind kNoComponent{"E408", "{} has no component '{}'"};
inline constexpr FindingKind kIndexCount{"E409", "'{}' has {} dimensions, {} are given"};
inline constexpr FindingKind kIndexRange{"E410", "index {} is outside 1 to {}"};
inline constexpr FindingKind kUnchangeable{"E411", "'{}' cannot be changed: {}"};
inline constexpr FindingKind kNoValues{"E412", "{} has no values"};
inline constexpr FindingKind kZeroDivision{"W413", "division by zero"};
inline constexpr FindingKind kNotWhole{"W415", "{} of a number that is not whole"};
inline constexpr FindingKind kQuaternionOff{"W416", "quaternion of length {} is taken as 1"};
inline constexpr FindingKind kNoQuaternion{"E417", "quaternion of length {} is none"};
inline constexpr FindingKind kNoSignal{"E419", "signal '{}' is not configured"};
inline constexpr FindingKind kNotOfChain{"W420", "NOT stands for the whole AND chain"};
inline constexpr FindingKind kNotLatin{"E421", "'{}' is no character of ISO 8859-1"};

// Calls.
inline constexpr FindingKind kNoProcedure{"E501", "there is no procedure '{}'"};
inline constexpr FindingKind kNotSupported{"E502", "{} is known but not supported: {}; {}"};
inline constexpr FindingKind kPassedOver{"W524", "{} is passed over, as asked"};
inline constexpr FindingKind kMissingArgument{"E503", "argument {} is missing"};
inline constexpr FindingKind kSurplusArgument{"E504", "one argument too many"};
inline constexpr FindingKind kNoOption{"E505", "no optional argument '\\{}'"};
inline constexpr FindingKind kOptionOrder{"E506", "'\\{}' twice or out of order"};
inline constexpr FindingKind kOptionExcluded{"E507", "'\\{}' excludes '\\{}'"};
inline constexpr FindingKind kSwitchValue{"E508", "'\\{}' is a switch and takes no value"};
inline constexpr FindingKind kOptionValue{"E509", "'\\{}' needs a value"};
inline constexpr FindingKind kArgumentForm{"E510", "{} takes {}"};
inline constexpr FindingKind kArgumentName{"E511", "the argument here is {}, not {}"};
inline constexpr FindingKind kNoOptionalParameter{"E512", "'{}' is no optional parameter here"};
inline constexpr FindingKind kArgumentDimensions{"E513", "{} takes {} dimensions, this has {}"};
inline constexpr FindingKind kTrapCalled{"E515", "a trap is not called"};
inline constexpr FindingKind kFunctionCalled{"E516", "'{}' is a function"};

// The flow of a routine.
inline constexpr FindingKind kNoLabel{"E601", "there is no label '{}'"};
inline constexpr FindingKind kLabelInside{"E602", "label '{}' is inside what this GOTO is not in"};
inline constexpr FindingKind kValueReturned{"E603", "only a function returns a value"};
inline constexpr FindingKind kNoValueReturned{"E604", "a function returns a value"};
inline constexpr FindingKind kEndOfFunction{"W605", "the end of '{}' can be reached without RETURN"};
inline constexpr FindingKind kOutsideHandler{"E606", "{} is for error handlers"};
inline constexpr FindingKind kNumberInHandler{"E607", "in a handler RAISE has no number"};
inline constexpr FindingKind kNoErrorNumber{"E608", "outside of a handler RAISE needs a number"};
inline constexpr FindingKind kErrorNumber{"W609", "{} is neither 1 to 90 nor booked"};
inline constexpr FindingKind kStepZero{"E610", "STEP 0 never ends"};
inline constexpr FindingKind kStepNotWhole{"W610", "numbers that are not whole may miss the end"};
inline constexpr FindingKind kUnreachable{"W611", "nothing gets here"};
inline constexpr FindingKind kInterruptOfRoutine{"W612", "this interrupt number ends with the routine"};
inline constexpr FindingKind kNoTrap{"E613", "'{}' is no trap"};
inline constexpr FindingKind kEarlierCase{"W614", "the value stands in an earlier CASE"};

inline constexpr FindingKind kSignalFile{"E905", "signal file: {}"};

/// All of them, in the order of their ids.
inline constexpr std::array kCheckFindings{kDeclaredAlready,
                                           kModuleName,
                                           kMain,
                                           kMainForm,
                                           kPersInRoutine,
                                           kInitialValue,
                                           kDimension,
                                           kThreeDimensions,
                                           kNoDataType,
                                           kNoInitialValue,
                                           kNeverDeclared,
                                           kSwitchParameter,
                                           kComponentTwice,
                                           kContainsItself,
                                           kResultType,
                                           kLabelTwice,
                                           kHidesPredefined,
                                           kThreePartConfdata,
                                           kLargeArray,
                                           kLargeProgram,
                                           kManyModules,
                                           kNotDeclared,
                                           kWrongKind,
                                           kNoOperation,
                                           kWrongType,
                                           kNoCondition,
                                           kUntypedAggregate,
                                           kParts,
                                           kNoComponent,
                                           kIndexCount,
                                           kIndexRange,
                                           kUnchangeable,
                                           kNoValues,
                                           kZeroDivision,
                                           kNotWhole,
                                           kQuaternionOff,
                                           kNoQuaternion,
                                           kNoSignal,
                                           kNotOfChain,
                                           kNotLatin,
                                           kNoProcedure,
                                           kNotSupported,
                                           kMissingArgument,
                                           kSurplusArgument,
                                           kNoOption,
                                           kOptionOrder,
                                           kOptionExcluded,
                                           kSwitchValue,
                                           kOptionValue,
                                           kArgumentForm,
                                           kArgumentName,
                                           kNoOptionalParameter,
                                           kArgumentDimensions,
                                           kTrapCalled,
                                           kFunctionCalled,
                                           kPassedOver,
                                           kNoLabel,
                                           kLabelInside,
                                           kValueReturned,
                                           kNoValueReturned,
                                           kEndOfFunction,
                                           kOutsideHandler,
                                           kNumberInHandler,
                                           kNoErrorNumber,
                                           kErrorNumber,
                                           kStepZero,
                                           kStepNotWhole,
                                           kUnreachable,
                                           kInterruptOfRoutine,
                                           kNoTrap,
                                           kEarlierCase,
                                           kSignalFile};

}  // namespace cobot_command::rapid::kinds
