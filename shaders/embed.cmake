# Writes a C++ file with the text of every shader as a raw string literal.
# ROOT: shader directory; NAMES: comma-separated paths below it; OUTPUT: the file to write.
string(REPLACE "," ";" names "${NAMES}")
set(code "#include \"gpu/embedded_shaders.h\"\n\nnamespace twintrace {\n\nnamespace {\n\n")
string(APPEND code "constexpr EmbeddedShader kShaders[] = {\n")
foreach(name IN LISTS names)
  file(READ "${ROOT}/${name}" text)
  string(APPEND code "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
endforeach()
string(APPEND code "};\n\n}  // namespace\n\n")
string(APPEND code "std::span<const EmbeddedShader> embeddedShaders() { return kShaders; }\n\n")
string(APPEND code "}  // namespace twintrace\n")
file(WRITE "${OUTPUT}" "${code}")
