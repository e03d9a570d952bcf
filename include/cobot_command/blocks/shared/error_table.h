// One table of errors for each block; the catalogue is all of them, one after the other. What blocks have in
// common is written once (shared_errors.cpp).
#pragma once

#include <initializer_list>
#include <vector>

namespace cobot_command::blocks {

/// Remedies of the thesis that many rows share. Where a text of the thesis does not fit, doc/thesis.md says
/// so.
inline constexpr const char* kCheckWiring = "Check Ethernet connection wiring";
inline constexpr const char* kSetInRange = "Set parameter in acceptable range";
inline constexpr const char* kExecuteAgain = "Re-execution is required";
/// Why a row of the thesis is only kept for its number.
inline constexpr const char* kNoSuchStep =
    "cannot occur any more: there is no such step, bytes are read as they come";

/// One row of a block's error table. The meaning of an id depends on the block.
struct ErrorRow {
  int id;                   ///< hexadecimal in the thesis: 16#10 is 0x10
  const char* description;  ///< "Error Description" column
  const char* remedy;       ///< "Action" column
  const char* raised_when;  ///< when this layer raises it, or why it cannot occur any more
};

/// An error that other blocks have too, under the number by which this one tells of it.
struct OwnNumber {
  int general;
  int own;
};

/// The rows of one block, in any order.
class ErrorTable {
 public:
  ErrorTable& row(int id, const char* description, const char* remedy, const char* raised_when);
  /// Rows with the texts that they have in all blocks. Precondition: shared_errors.cpp has the id.
  ErrorTable& shared(std::initializer_list<int> ids);
  /// The same, raised under another condition here.
  ErrorTable& shared(int id, const char* raised_when);

  /// Raised under another condition, for a row that is there already.
  ErrorTable& condition(int id, const char* raised_when);
  /// Another remedy for a row that is there already.
  ErrorTable& remedy(int id, const char* remedy);

  /// The block tells of common failures under numbers of its own, with rows of its own: who finds one names
  /// it by its general number, as everywhere. Several may have the same own number. In this order they
  /// decide, before all other rows.
  ErrorTable& instead(std::initializer_list<OwnNumber> numbers);

  /// The steps of the thesis that every one of its command blocks has: build, send, receive.
  ErrorTable& thesisCommand();
  /// A command_id that is only echoed. The thesis has no such row in the blocks without a queue tag: it sends
  /// any number there, as the id of the script.
  ErrorTable& echoedCommandId();
  /// What comes between a goal and its script, with any command of this layer.
  ErrorTable& anyCommand();
  /// To wait for one's turn, with a robot that may move.
  ErrorTable& turn();
  /// What may move the arm, while exchange_configuration rules.
  ErrorTable& underInterface();
  /// What may move the arm, or leave the Listen node, while a cell rules.
  ErrorTable& inCell();
  /// What moves the arm: its plan, and its way from the acceptance to the tag, or to a stop.
  ErrorTable& motion();
  /// That, and the parameters of a move.
  ErrorTable& move();
  /// A target as a pose in a tf frame.
  ErrorTable& framedPose();

  /// Ordered by id.
  [[nodiscard]] std::vector<ErrorRow> rows() const;
  /// In the order in which they decide.
  [[nodiscard]] const std::vector<OwnNumber>& ownNumbers() const { return own_numbers_; }

 private:
  std::vector<ErrorRow> rows_;
  std::vector<OwnNumber> own_numbers_;
};

}  // namespace cobot_command::blocks
