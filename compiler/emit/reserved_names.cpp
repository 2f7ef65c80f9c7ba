#include "compiler/emit/reserved_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace mbgen {
namespace {

/// Keywords, alternative tokens, macros of the C library's headers and of compilers, and global names of <cmath>.
const std::set<std::string_view>& reserved_names() {
  static const std::set<std::string_view> names = {
      "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
      "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "const", "consteval", "constexpr", "constinit",
      "const_cast", "continue", "co_await", "co_return", "co_yield", "decltype", "default", "delete", "do", "double",
      "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if",
      "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
      "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires", "return", "short",
      "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template", "this",
      "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "typeof", "union", "unsigned", "using",
      "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq",
      // Macros that <cmath> and compilers define and that do not look like it, see may_be_macro.
      "HUGE", "INFINITY", "NAN", "SNAN", "NULL", "EOF", "MAXFLOAT", "DOMAIN", "SING", "SNANL", "NFDBITS", "WCONTINUED",
      "WEXITED", "WNOHANG", "WNOWAIT", "WSTOPPED", "WUNTRACED", "OVERFLOW", "UNDERFLOW", "PLOSS", "TLOSS", "errno",
      "math_errhandling", "unix", "linux", "i386",
      // Namespaces and types that emitted code uses.
      "std", "mbgen", "Index", "Coordinate", "Body", "Input", "Output", "Parameter", "LoopBlock", "Inputs", "Outputs",
      "Parameters", "Tuned", "State", "Derivative", "Multipliers", "History", "System", "Lanes", "Mask",
      // Constants of the interface.
      "kModel", "kHash", "kCoordinates", "kAuxiliaryStates", "kBodies", "kInputs", "kOutputs", "kParameters",
      "kLoopBlocks", "kClosureEquations", "kMotions", "kCoordinateNames", "kCoordinateUnits", "kAuxiliaryStateNames",
      "kBodyNames", "kInputNames", "kInputUnits", "kOutputNames", "kOutputUnits", "kParameterNames", "kParameterUnits",
      "kLoopBlockNames", "kLanes",
      // Types of the C library.
      "int8_t", "size_t", "div_t", "float_t", "double_t",
      // Functions of <cmath> and <cstdlib>, which C libraries declare in the global namespace.
      "abs", "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "ceil", "copysign", "cos", "cosh",
      "div", "drem", "erf", "erfc", "exit", "exp", "exp10", "exp2", "expm1", "fabs", "fdim", "finite", "floor", "fma",
      "fmax", "fmin", "fmod", "frexp", "free", "gamma", "hypot", "ilogb", "isinf", "isnan", "j0", "j1", "jn", "labs",
      "ldexp", "lgamma", "llrint", "log", "log10", "log1p", "log2", "logb", "lrint", "lround", "modf", "nan",
      "nearbyint", "nextafter", "pow", "pow10", "rand", "random", "remainder", "remquo", "rint", "round", "scalb",
      "scalbn", "select", "signbit", "significand", "signgam", "sin", "sincos", "sinh", "sqrt", "system", "tan", "tanh",
      "tgamma", "trunc", "y0", "y1", "yn"};
  return names;
}

/// Names beside which there is no namespace, between blanks: the types of the interface, and what the headers of the C
/// library and POSIX declare. Of mathematical functions those for double; their sisters end in kPrecisions.
constexpr std::string_view kGlobalNames =
    " main Dynamics ClosureResidual lanes batch Row kGroups mbgen_solver_table a64l abort accept access acct"
    " alarm aligned_alloc alloca arc4random arc4random_buf arc4random_uniform asctime at_quick_exit atexit atof"
    " atoi atol atoll basename bcmp bcopy bind brk bsearch bzero calloc canonicalize canonicalize_file_name"
    " chdir chmod chown chroot clearenv clock clock_adjtime clock_getcpuclockid clock_getres clock_gettime"
    " clock_nanosleep clock_settime close connect creat crypt ctime daddl daylight ddivl dfmal difftime dmull"
    " drand48 drand48_data dsqrtl dsubl dup dup2 dysize ecvt encrypt environ erand48 execl execv"
    " explicit_bzero fadd fclose fcvt fd_mask fd_set fdiv ffma ffs ffsll fmaximum fmaximum_mag"
    " fmaximum_mag_num fmaximum_num fmaxmag fminimum fminimum_mag fminimum_mag_num fminimum_num fminmag fmul"
    " fopen fork fread fromfp fromfpx fsqrt fstat fsub fwrite gcvt getc getchar getcwd getdate getdate_err"
    " getenv getloadavg getpayload getpt gets getsubopt gmtime grantpt index initstate isalpha isatty"
    " iscanonical isdigit iseqsig issignaling isspace iszero itimerspec jrand48 kill l64a lcong48 ldiv link"
    " listen llabs lldiv llogb llround localtime lockf longjmp lrand48 lseek lstat malloc mblen mbstowcs"
    " mbtowc memccpy memchr memcmp memcpy memfrob memmem memmove mempcpy memrchr memset mkdir mkdtemp mknod"
    " mkostemp mkostemp64 mkostemps mkostemps64 mkstemp mkstemp64 mkstemps mkstemps64 mktemp mktime mount"
    " mrand48 nanosleep nextdown nexttoward nextup nice nrand48 on_exit open optarg optind pause perror pipe"
    " poll posix_memalign posix_openpt printf pselect psignal ptsname putc putchar putenv puts qecvt qfcvt"
    " qgcvt qsort quick_exit raise random_data rawmemchr read realloc reallocarray realpath reboot recv"
    " remove rename rewind rindex rmdir roundeven rpmatch sbrk scalbln scanf secure_getenv seed48 send setenv"
    " setjmp setpayload setpayloadsig setstate shutdown sigabbrev_np sigaction sigdescr_np sigevent signal"
    " sigvec sleep socket splice srand srand48 srandom stat stderr stdin stdout stime stpcpy stpncpy"
    " strcasecmp strcasestr strcat strchr strchrnul strcmp strcoll strcpy strcspn strdup strerror"
    " strerrordesc_np strerrorname_np strfrom strfromd strfromf strfroml strfry strftime strlen strncasecmp"
    " strncat strncmp strncpy strndup strnlen strpbrk strptime strrchr strsep strsignal strspn strstr strto"
    " strtod strtof strtok strtol strtold strtoll strtoq strtoul strtoull strtouq strverscmp strxfrm swab"
    " symlink sync tee time timegm timelocal timer_create timer_delete timer_getoverrun timer_gettime"
    " timer_settime timespec timespec_get timespec_getres timeval timex timezone tm tmpfile tolower"
    " totalorder totalordermag toupper truncate ttyname tzname tzset u_char u_int u_long u_quad_t u_short"
    " ufromfp ufromfpx uint ulong umask umount unlink unlockpt unsetenv ushort usleep valloc vfork vhangup"
    " wait wcstombs wctomb write ";

/// Targets of CMake's generators, between blanks.
constexpr std::string_view kBuildTargets =
    " all help install preinstall clean depend edit_cache rebuild_cache test package package_source"
    " list_install_components install_local install_strip ALL_BUILD INSTALL RUN_TESTS PACKAGE ZERO_CHECK ";

bool is_one_of(std::string_view list, std::string_view name) {
  return list.find(fmt::format(" {} ", name)) != std::string_view::npos;
}

/// What the library's functions for other types than double end in, longest first.
constexpr std::string_view kPrecisions[] = {
    "f128_r", "f128_l", "f32x_r", "f32x_l", "f64x_r", "f64x_l", "f32_r", "f32_l", "f64_r", "f64_l", "f128", "f32x",
    "f64x",   "f32",    "f64",    "f_r",    "l_r",    "f_l",    "l_l",   "_r",    "_l",    "f",     "l"};

bool is_upper_case(std::string_view name) {
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
}

bool may_be_macro(std::string_view name) {
  if (is_upper_case(name) && name.find('_') != std::string_view::npos) return true;
  return name.starts_with("M_") || name.starts_with("HUGE_VAL") || name.starts_with("SNANF");
}

/// Whether the C library has a function of this name for another type than double: `sinf`, `f64mulf128`.
bool is_of_other_precision(std::string_view name) {
  if (name.starts_with("f32") || name.starts_with("f64")) return true;
  for (const std::string_view ending : kPrecisions) {
    if (!name.ends_with(ending)) continue;
    const std::string_view start = name.substr(0, name.size() - ending.size());
    if (is_one_of(kGlobalNames, start) || reserved_names().count(start) > 0) return true;
  }
  return false;
}

}  // namespace

bool is_reserved(std::string_view name) { return reserved_names().count(name) > 0 || may_be_macro(name); }

bool is_reserved_for_solvers(std::string_view name) {
  return is_one_of(kGlobalNames, name) || is_one_of(kBuildTargets, name) || name.ends_with("_t") ||
         is_of_other_precision(name);
}

}  // namespace mbgen
