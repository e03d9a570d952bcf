# The function blocks, by the names of their headers: COBOT_BLOCKS, read from the one list of them, so that a new block
# is built where its sources stand. Its files have the name of its header: src/blocks/<block>.cpp and so on.
set(block_list ${PROJECT_SOURCE_DIR}/include/cobot_command/blocks/list/goal.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${block_list})
file(STRINGS ${block_list} COBOT_BLOCKS REGEX "^#include \"cobot_command/blocks/(waits/|ways_back/)?[a-z_]+\\.h\"$")
list(TRANSFORM COBOT_BLOCKS REPLACE "^.*/blocks/(.+)\\.h\"$" "\\1")
