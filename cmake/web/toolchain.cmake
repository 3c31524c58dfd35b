# Toolchain for WebAssembly: the clang that Debian's emscripten uses, called directly, because emcc itself starts Python for
# every source and cannot be cached. Only the program is linked by em++.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # nothing is linked while configuring

find_program(ASHIMPACT_EMXX em++ REQUIRED)
find_program(ASHIMPACT_EMCONFIG em-config REQUIRED)
execute_process(COMMAND "${ASHIMPACT_EMXX}" --cflags OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${ASHIMPACT_EMCONFIG}" LLVM_ROOT OUTPUT_VARIABLE llvm OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
# Exceptions are those of WebAssembly, which cost nothing until one is thrown.
string(REPLACE "-fignore-exceptions" "-fwasm-exceptions" flags "${flags}")
string(REPLACE "-Xclang -iwithsysroot/include/SDL" "" flags "${flags}")

# Debian has clang-14 beside the llvm of the same release; a clang without a number serves as well.
find_program(ASHIMPACT_WASM_CC NAMES clang-14 clang-19 clang PATHS "${llvm}" REQUIRED)
find_program(ASHIMPACT_WASM_CXX NAMES clang++-14 clang++-19 clang++ PATHS "${llvm}" REQUIRED)
find_program(ASHIMPACT_WASM_AR NAMES llvm-ar-14 llvm-ar-19 llvm-ar PATHS "${llvm}" REQUIRED)
find_program(ASHIMPACT_WASM_RANLIB NAMES llvm-ranlib-14 llvm-ranlib-19 llvm-ranlib PATHS "${llvm}" REQUIRED)
set(CMAKE_C_COMPILER "${ASHIMPACT_WASM_CC}")
set(CMAKE_CXX_COMPILER "${ASHIMPACT_WASM_CXX}")
set(CMAKE_AR "${ASHIMPACT_WASM_AR}" CACHE FILEPATH "")
set(CMAKE_RANLIB "${ASHIMPACT_WASM_RANLIB}" CACHE FILEPATH "")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")

set(CMAKE_EXECUTABLE_SUFFIX .js)
# em++ runs node, which has to find Debian's acorn even if it is not Debian's node.
set(CMAKE_CXX_LINK_EXECUTABLE "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs \"${ASHIMPACT_EMXX}\" -fwasm-exceptions <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")

# Headers and libraries of this machine are none of ours.
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
