// The findings of reading: id and text of each. `{}` is replaced by what was found.
#pragma once

#include <array>
#include <string_view>

namespace cobot_command::rapid {

struct FindingKind {
  std::string_view id;
  std::string_view text;
};

namespace kinds {

// Lexical: the characters.
inline constexpr FindingKind kUnknownCharacter{"E101", "'{}' means nothing in RAPID"};
inline constexpr FindingKind kLongName{"E102", "'{}' has {} letters, {} allows {}"};
inline constexpr FindingKind kOpenText{"E103", "this text is not closed on its line"};
inline constexpr FindingKind kLongText{"E104", "this text has {} characters, {} are allowed"};
inline constexpr FindingKind kCharacterCode{"E105", "'{}' is no character code"};
inline constexpr FindingKind kNoNumber{"E106", "'{}' is no number"};
inline constexpr FindingKind kLargeNumber{"E107", "{} is beyond single precision"};
inline constexpr FindingKind kReservedWord{"E109", "{} is a reserved word"};

// Syntax: the order of the tokens.
inline constexpr FindingKind kExpected{"E201", "expected {}, found {}"};
inline constexpr FindingKind kNoSemicolon{"E202", "';' is missing"};
inline constexpr FindingKind kNotClosed{"E203", "{} is not closed by {}"};
inline constexpr FindingKind kEndsNothing{"E204", "{} has nothing before it that it could end"};
inline constexpr FindingKind kLateDeclaration{"E205", "declarations stand before routines and instructions"};
inline constexpr FindingKind kNoComma{"E206", "',' is missing before this argument"};
inline constexpr FindingKind kCommaBeforeOption{"E207", "no ',' before '\\' in s4c"};
inline constexpr FindingKind kNoAttribute{"E208", "'{}' is no attribute here"};
inline constexpr FindingKind kAssignMeant{"E209", "':=' is meant"};
inline constexpr FindingKind kHandlerOrder{"E210",
                                           "{} a second time or out of order (BACKWARD, ERROR, UNDO)"};
inline constexpr FindingKind kBackwardOfProc{"E211", "only a PROC has a BACKWARD handler"};
inline constexpr FindingKind kLocalInRoutine{"E213", "LOCAL is for modules"};
inline constexpr FindingKind kOutsideModule{"E214", "'{}' stands outside of a module"};
inline constexpr FindingKind kStarPosition{"E215", "'*' was a position that only the robot knew"};
inline constexpr FindingKind kHeader{"E216", "the header reads %%% VERSION:1 LANGUAGE:ENGLISH %%%"};
inline constexpr FindingKind kPlaceholder{"W217", "placeholder: raises ERR_EXECPHR when reached"};
inline constexpr FindingKind kSomethingMissing{"E218", "something is missing here"};
inline constexpr FindingKind kNestedTooDeep{"E219", "nested deeper than {}"};
inline constexpr FindingKind kCallBrackets{"E220", "a procedure is called without brackets"};

// What the form of a declaration or of a TEST shows without knowing names and types.
inline constexpr FindingKind kPersNoValue{"E306", "PERS '{}' has no value"};
inline constexpr FindingKind kPersZero{"W306", "PERS '{}' has no value"};
inline constexpr FindingKind kConstNoValue{"E311", "CONST '{}' has no value"};
inline constexpr FindingKind kAfterDefault{"E615", "nothing stands behind DEFAULT"};

// The dialect, and the file as a whole.
inline constexpr FindingKind kNotInS4c{"E801", "{} is not in s4c"};
inline constexpr FindingKind kUnreadable{"E901", "cannot be read: {}"};
inline constexpr FindingKind kNoSourceText{"E902", "no text (encoded module?)"};
inline constexpr FindingKind kManyFindings{"E903", "more than {} findings"};
inline constexpr FindingKind kLongFile{"E904", "longer than {} MiB"};

}  // namespace kinds

/// All of them, in the order of their ids.
inline constexpr std::array kReadingFindings{
    kinds::kUnknownCharacter, kinds::kLongName,       kinds::kOpenText,
    kinds::kLongText,         kinds::kCharacterCode,  kinds::kNoNumber,
    kinds::kLargeNumber,      kinds::kReservedWord,   kinds::kExpected,
    kinds::kNoSemicolon,      kinds::kNotClosed,      kinds::kEndsNothing,
    kinds::kLateDeclaration,  kinds::kNoComma,        kinds::kCommaBeforeOption,
    kinds::kNoAttribute,      kinds::kAssignMeant,    kinds::kHandlerOrder,
    kinds::kBackwardOfProc,   kinds::kLocalInRoutine, kinds::kOutsideModule,
    kinds::kStarPosition,     kinds::kHeader,         kinds::kPlaceholder,
    kinds::kSomethingMissing, kinds::kNestedTooDeep,  kinds::kCallBrackets,
    kinds::kPersNoValue,      kinds::kPersZero,       kinds::kConstNoValue,
    kinds::kAfterDefault,     kinds::kNotInS4c,       kinds::kUnreadable,
    kinds::kNoSourceText,     kinds::kManyFindings,   kinds::kLongFile};

}  // namespace cobot_command::rapid
