# Run as a script: writes OUTPUT, a C++ source with the text of FILE as a constant std::string_view. It is named CONSTANT, is in
# NAMESPACE and is declared in HEADER.
file(READ ${FILE} text)
# In pieces: a compiler need not take a string literal of more than 64 KiB.
string(REGEX REPLACE "(\n[^\n]*\n[^\n]*\n[^\n]*\n)" "\\1)text\"\n    R\"text(" text "${text}")
get_filename_component(name ${FILE} NAME)
file(WRITE ${OUTPUT} "// Generated from ${name}; edit that.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n"
     "const std::string_view ${CONSTANT} =\n    R\"text(${text})text\";\n\n}  // namespace ${NAMESPACE}\n")
