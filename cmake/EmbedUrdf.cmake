# Run as a script: writes OUTPUT, a C++ source that holds the text of each of FILES (a list) by the file's stem.
# The programs so know their robots wherever they are installed.
set(code "// Generated from urdf/*.urdf; edit those.\n#include \"embedded_urdfs.h\"\n\n")
string(APPEND code "namespace cobot_command::arm {\n\nconst std::vector<EmbeddedUrdf>& embeddedUrdfs() {\n")
string(APPEND code "  static const std::vector<EmbeddedUrdf> urdfs = {\n")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  # In pieces: a compiler need not take a string literal of more than 64 KiB.
  string(REGEX REPLACE "(</link>)" "\\1)urdf\"\n     R\"urdf(" text "${text}")
  string(APPEND code "    {\"${name}\",\n     R\"urdf(${text})urdf\"},\n")
endforeach()
string(APPEND code "  };\n  return urdfs;\n}\n\n}  // namespace cobot_command::arm\n")
file(WRITE ${OUTPUT} "${code}")
