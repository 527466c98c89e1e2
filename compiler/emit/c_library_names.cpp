#include "emit/names.hpp"

namespace mbcc::cpp {

namespace {

/// What the headers that emitted code includes declare in the global namespace, without the variants for other types
/// of number (sinf, sinl); glibc 2.36.
constexpr std::string_view names =
    // clang-format off
    " abort abs access acct acos acosh alarm alloca asctime asin asinh atan atan2 atanh atexit bcmp bcopy brk btowc"
    " bzero canonicalize cbrt ceil chdir chroot clearenv clearerr clock clock_adjtime clock_getcpuclockid clock_getres"
    " clone close closefrom cookie_close_function_t cookie_seek_function_t copysign cos cosh ctime daddl daemon"
    " daylight ddivl dfmal div dmull drand48 drem dsqrtl dsubl dup dup2 dup3 duplocale dysize endl ends endusershell"
    " environ erand48 erf erfc errno exit exp exp10 exp2 expm1 fabs fadd fchdir fchown fclose fcloseall fdatasync fdim"
    " fdiv feof ferror fflush ffma ffs fgetc fgetpos fgetwc fileno flockfile floor flush fma fmax fmaximum"
    " fmaximum_mag fmaximum_mag_num fmaximum_num fmaxmag fmin fminimum fminimum_mag fminimum_mag_num fminimum_num"
    " fminmag fmod fmul fork fpathconf fputc fputs fputwc free freelocale frexp fromfp fromfpx fscanf fseek fseeko"
    " fsetpos fsqrt fsub fsync ftell ftello ftruncate ftrylockfile funlockfile fwide gamma get_current_dir_name getc"
    " getchar getcpu getcwd getdate getdtablesize getegid getenv geteuid getgid gethostid getlogin getpagesize getpass"
    " getpayload getpgid getpgrp getpid getppid getpt getsid gettid getuid getusershell getw getwc getwchar gmtime"
    " grantpt group_member hypot ilogb index isalnum isalpha isascii isatty isblank iscntrl isctype isdigit isgraph"
    " islower isprint ispunct isspace isupper iswalnum iswalpha iswblank iswcntrl iswctype iswdigit iswgraph iswlower"
    " iswprint iswpunct iswspace iswupper iswxdigit isxdigit j0 j1 jn kill labs lcong48 ldexp ldiv lgamma link linux"
    " llogb llrint llround localeconv localtime lockf log log10 log1p log2 logb lrand48 lrint lround lseek main mblen"
    " mbrt mbsinit memset mkdtemp mkostemp mkstemp mkstemps mktemp mktime modf mrand48 nan nearbyint nextafter"
    " nextdown nexttoward nextup nice open optarg optind pause pclose perror pipe pipe2 posix posix_openpt pow printf"
    " pthread_attr_init pthread_cancel pthread_detach pthread_exit pthread_getconcurrency pthread_getspecific"
    " pthread_join pthread_key_delete pthread_self pthread_setcancelstate pthread_setcanceltype pthread_setconcurrency"
    " pthread_testcancel pthread_yield ptsname putc putchar putenv puts putw putwc putwchar quick_exit raise rand"
    " random read remainder remove remquo rename revoke rewind rindex rint rmdir round roundeven rpmatch sbrk scalb"
    " scalbln scalbn scanf sched_get_priority_max sched_get_priority_min sched_getcpu sched_getparam"
    " sched_getscheduler sched_rr_get_interval sched_yield select setbuf setegid seteuid setgid sethostid setlinebuf"
    " setlocale setlogin setns setpayload setpayloadsig setpgid setpgrp setregid setreuid setsid setstate setuid"
    " setusershell signal signgam significand sin sincos sinh sleep sqrt srand srand48 srandom sscanf stat std stderr"
    " stdin stdout strerror strfry strsignal swab sync syncfs syscall sysconf system tan tanh tcgetpgrp tcsetpgrp"
    " tgamma time timegm timelocal timer_delete timer_getoverrun times timezone tmpnam toascii tolower toupper"
    " towctrans towlower towupper trunc truncate ttyname ttyslot tzname tzset ufromfp ufromfpx ungetc ungetwc unix"
    " unlink unlockpt unsetenv unshare uselocale usleep vfork vhangup vprintf wait wcscasecmp wcscoll wcslen wcswidth"
    " wctob wctomb wctrans wctype wcwidth wmemset write y0 y1 yn"
    " ";
// clang-format on

bool is_listed(std::string_view name) { return names.find(" " + std::string(name) + " ") != std::string_view::npos; }

}  // namespace

bool is_global_name(std::string_view name) {
  const std::string_view stem = name.substr(0, name.empty() ? 0 : name.size() - 1);
  const bool has_suffix = !name.empty() && (name.back() == 'f' || name.back() == 'l');
  return is_listed(name) || (has_suffix && is_listed(stem));
}

}  // namespace mbcc::cpp
