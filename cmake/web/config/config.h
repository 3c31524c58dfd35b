/* For Nettle compiled to WebAssembly. GSL has a config.h of its own, which comes first. */
#define HAVE_UNISTD_H 1
#define HAVE_ALLOCA_H 1
#define WORDS_BIGENDIAN 0
#undef WORDS_BIGENDIAN
