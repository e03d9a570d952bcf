// The error table of a block. The catalogue consists of the tables of all blocks. Errors that several blocks
// have are defined once (shared_errors.cpp).
#pragma once

#include <initializer_list>
#include <vector>

namespace cobot_command::blocks {

/// Remedies of the thesis that many rows share. doc/thesis.md lists the texts of the thesis that do not fit.
inline constexpr const char* kCheckWiring = "Check Ethernet connection wiring";
inline constexpr const char* kSetInRange = "Set parameter in acceptable range";
inline constexpr const char* kExecuteAgain = "Re-execution is required";
/// Condition of a row of the thesis that is kept only for its number.
inline constexpr const char* kNoSuchStep =
    "cannot occur any more: this step does not exist, bytes are read as they arrive";

/// One row of a block's error table. The meaning of an id depends on the block.
struct ErrorRow {
  int id;                   ///< hexadecimal in the thesis: 16#10 is 0x10
  const char* description;  ///< "Error Description" column
  const char* remedy;       ///< "Action" column
  const char* raised_when;  ///< when this layer raises it, or why it can no longer occur
};

/// An error that other blocks have too (`general`), and the number under which this block reports it (`own`).
struct OwnNumber {
  int general;
  int own;
};

/// The rows of one block, in any order.
class ErrorTable {
 public:
  ErrorTable& row(int id, const char* description, const char* remedy, const char* raised_when);
  /// Adds rows with the texts that they have in all blocks. Precondition: shared_errors.cpp has the id.
  ErrorTable& shared(std::initializer_list<int> ids);
  /// The same for one id, with another condition in this block.
  ErrorTable& shared(int id, const char* raised_when);

  /// Changes the condition of a row that was already added.
  ErrorTable& condition(int id, const char* raised_when);
  /// Changes the remedy of a row that was already added.
  ErrorTable& remedy(int id, const char* remedy);

  /// The block reports these common failures under its own numbers, with its own rows. Code that finds such a
  /// failure uses its general number, as everywhere. Several failures may have the same own number. They take
  /// precedence over all other rows, in this order.
  ErrorTable& instead(std::initializer_list<OwnNumber> numbers);

  /// Steps that every command block of the thesis has: build, send, receive.
  ErrorTable& thesisCommand();
  /// A command_id that is only echoed. The thesis has no such row in the blocks without a queue tag: there it
  /// sends any number, as the id of the script.
  ErrorTable& echoedCommandId();
  /// Errors between the goal and its script, for any command of this layer.
  ErrorTable& anyCommand();
  /// Errors while a goal waits for its turn, with a robot that may move.
  ErrorTable& turn();
  /// For goals that may move the arm, while exchange_configuration is enabled or required.
  ErrorTable& underInterface();
  /// For goals that may move the arm or leave the Listen node, on a node that belongs to a cell.
  ErrorTable& inCell();
  /// For goals that move the arm: errors of the plan, and from the acceptance to the tag or to a stop.
  ErrorTable& motion();
  /// motion(), and the errors of the parameters of a move.
  ErrorTable& move();
  /// For a target that is a pose in a tf frame.
  ErrorTable& framedPose();

  /// Ordered by id.
  [[nodiscard]] std::vector<ErrorRow> rows() const;
  /// In order of precedence.
  [[nodiscard]] const std::vector<OwnNumber>& ownNumbers() const { return own_numbers_; }

 private:
  std::vector<ErrorRow> rows_;
  std::vector<OwnNumber> own_numbers_;
};

}  // namespace cobot_command::blocks
