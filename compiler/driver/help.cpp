#include "driver/help.hpp"

#include <fmt/format.h>

#include <array>

#include "driver/manual.hpp"
#include "graph/operators.hpp"

namespace mbcc {

namespace {

constexpr std::string_view overview = R"(mbcc: a compiler for mechanics

  mbcc MODEL.mbd -o SIM.cpp            compile a model to one C++ program (-o - is standard output)
       --library                       the class alone: no main, no allocation, no streams
       --depfile FILE                  the files that the output depends on, for make and ninja
  mbcc run MODEL.mbd [flags]           compile, build and run; flags are the simulation's (mbcc help run)
       --plot FIGURE                   and draw what was recorded (mbcc help plot)
  mbcc plot RESULT.csv ... -o FIGURE   draw recorded results, several over each other
  mbcc check MODEL.mbd                 diagnostics, then the structure of the model
  mbcc verify MODEL.mbd SIM.cpp        is SIM.cpp what this mbcc emits for the model?
  mbcc dump MODEL.mbd --stage=STAGE    tokens, syntax, system, equations, derivatives [--partials] or program
  mbcc dialog [MODEL.mbd]              ask for a model, question by question, as plain mbcc does (mbcc help dialog)
  mbcc help TOPIC                      language, functions, run, plot, dialog, exit; manual is all of it as a page for man
  mbcc --version

With every command: --strict (forces and constraints in the paper's grammar), --werror, --diagnostics=json.
MODEL may be - for standard input.
)";

constexpr std::string_view language = R"(A model in one page

  system pendulum                          # comments run to the line's end
  dimension 2                              # 1, 2 or 3
  parameter L = 0.5                        # may be set when running: --set L=0.7
  constant  N = 10                         # fixed when compiling; counts and bounds

  particle bob {                           # bob.x, bob.vx, bob.position, bob.velocity
    mass     = 1
    position = (0, -L)
    velocity = (1, 0)
  }
  particle 1 { mass = 1; position = (1, 0) }         # x1, y1, vx1, vy1
  gravity (0, -9.81)
  force on bob = -0.1*bob.velocity         # any number of times
  constraint rod : norm(bob.position)^2 = L^2
  constraint     : x1*vx1 + y1*vy1         # no `=`: the expression is zero
  for i in 1..N { particle p[i] { mass = 1; position = (i, 0) } }
  let r = norm(bob.position)
  output tension = sum(i in 1..N, p[i].x)
  point middle = bob.position/2            # a position, on which forces may act
  module Swing(m, L = 1) {                 # a system with parameters and ports ...
    point pivot = (0, 0)
    particle seat { mass = m; position = pivot + (L, 0) }
    constraint rope : norm(seat.position - pivot) = L
  }
  part swing = Swing(m = 10) { pivot = middle }    # ... as a part of this one: swing.seat.x
  integrate { from = 0; to = 10; step = 0.001; method = rk4 }

A prime is the total time derivative: (x1*y1)'. Holonomic or not is decided from the variables that occur.
`import "other.mbd"` reads another file. `mbcc help functions` lists functions; `mbcc help run` the flags of a run.
)";

constexpr std::string_view run = R"(Flags of `mbcc run MODEL.mbd` and of emitted programs

  --from T0 --to T1 --step H           times; the model's `integrate` gives the defaults
  --method NAME                        rk4: classical Runge-Kutta with constant step; dop853: order 8, chooses its steps;
                                       taylor: series of high order, chooses its steps; radau: implicit, of order 5,
                                       chooses its steps, for stiff motions; auto: dop853, which gives way to
                                       radau where a motion turns out to be stiff, or taylor at tight tolerances.
                                       Without a method in the model or on the line it is rk4 where there is a step,
                                       else auto
  --tolerance TOL                      error per step, relative to the state and its size at the start (default 1e-9)
  --set NAME=VALUE ...                 parameters
  --initial NAME=VALUE ...             coordinates and speeds at the start
  --assemble --fix NAME ...            move the start to the nearest consistent one; what is fixed or given stays
  --project on|off                     move each step's end onto the constraints (on, but for rk4)
  --stabilize B1,B2,B3                 Baumgarte: h'' + 2 B1 B2 h' + B2^2 h = 0, g' + B3 g = 0
  --csv FILE --every DT                record rows (- is standard output)
  --npy FILE                           the same rows for NumPy: five times as fast to write, less than half as large
  --residuals                          record the errors of every constraint and the energy too, as further columns
  --summary FILE                       JSON: errors of every constraint, energy, rank, steps, times
  --cutoff X                           singular values below X of the largest count as zero (default 1e-8)
  --repeat N                           also time N runs without monitors
  --quiet --progress

Of mbcc itself, for the build (kept by content in the user's cache): --cxxflags="-O3 -march=native", and CXX in the
environment. Without a C++ compiler the model is interpreted.
)";

constexpr std::string_view plot = R"(Figures

  mbcc run MODEL.mbd --plot FIGURE [flags]      run, and draw what was recorded
  mbcc plot RESULT.csv ... -o FIGURE            draw files that `--csv` has recorded

FIGURE ends in .svg, .png or .pdf, drawn by gnuplot (in Debian the package gnuplot-nox), in .gp: the script for it, or
in .html: a page for a browser with the same panels, to zoom, beside the moving scene. It needs nothing but itself.

A picture shows all figures side by side, a pdf each on a page of its own:

  each particle           coordinates, velocities, accelerations
  constraint errors       of position, velocity and acceleration, on logarithmic axes; the largest of more than seven
  energy and outputs      how far the energy is from where it began, and each output

Errors and energy are drawn from columns that `--residuals` records. `--plot` adds them; it draws the file of `--csv`
if there is one, else a recording that does not stay. A run that fails or is interrupted is drawn as far as it came.

Of several results, at most five, each has a dash pattern, and the first lies broad and pale under the others. What does
not move is drawn as a level line, rounding errors and all. Long results are thinned so that every peak stays; the rows
of short ones are joined by monotone splines, which go through every row and never beyond two neighbours.
)";

constexpr std::string_view dialog = R"(Asking for a model: mbcc dialog [MODEL.mbd] [-o OUT.mbd] [--force]

  A name                               a letter, then letters and digits; the first 7 count
  B dimension                          1, 2 or 3
  C particles                          how many
  D constraints                        how many equations, 0 for none
  E m1, m2, ...                        masses
  F fx1, fy1, ...                      components of forces: expressions of t, x1, vx1, ...
  G g1, g2, ...                        equations such as x1^2 + y1^2 = 1, or what is to be zero
  H x1, vx1, ...                       coordinates and velocities at the start: numbers such as 2 or sqrt(2)/2
  I step, initial and final time       numbers

ENTER takes what stands in the line, `?` explains the question, `back` returns to the dialog before. After A, E, F and G
Y or ENTER goes on, anything else asks that dialog again with its answers in the lines. A wrong answer is explained and
asked for again. A start off the constraints is reported, and the nearest one on them offered.

The model goes to NAME.mbd, the program to cNAME.cpp; then `check`, `run` and `plot` show what they are. A dialog that is
left is kept in NAME.mbd.draft; the next one of that name goes on with it. From MODEL.mbd the dialog changes what is
answered otherwise, and leaves all else as it is. Answers may come from a script, one a line; it must say --force to
replace files.
)";

constexpr std::string_view exit_codes = R"(Exit codes

   0  fine, warnings included
   1  the model is wrong, or a check failed (with --werror also warnings)
   2  wrong usage, unreadable input, unwritable output
   3  the simulation failed while running
  70  a bug in mbcc
 130  interrupted
)";

std::string functions() {
  std::string text = "Functions, by number of arguments\n\n";
  for (int arity = 1; arity <= 3; ++arity) {
    text += fmt::format("  {}:", arity);
    for (const graph::OperatorRow& row : graph::operator_table) {
      if (row.arity == arity && graph::find_function(row.spelling) == row.op) {
        text += fmt::format(" {}", row.spelling);
      }
    }
    text += "\n";
  }
  return text + R"(
  vectors: dot cross norm; sum(j in 1..N, expression)

`ln` is natural, `log` is base 10. `if(a < b, x, y)` takes a comparison. `min`, `max` and `hypot` take two or more.
)";
}

constexpr std::array topics = {
    HelpTopic{"", "COMMANDS", [] { return std::string(overview); }},
    HelpTopic{"language", "MODELS", [] { return std::string(language); }, true},
    HelpTopic{"functions", "FUNCTIONS", functions},
    HelpTopic{"run", "RUNS", [] { return std::string(run); }},
    HelpTopic{"plot", "FIGURES", [] { return std::string(plot); }},
    HelpTopic{"dialog", "DIALOG", [] { return std::string(dialog); }},
    HelpTopic{"exit", "EXIT STATUS", [] { return std::string(exit_codes); }},
    HelpTopic{"manual", "", manual_page},
};

}  // namespace

std::span<const HelpTopic> help_topics() { return topics; }

std::optional<std::string> help_text(std::string_view topic) {
  for (const HelpTopic& candidate : topics) {
    if (candidate.name == topic) {
      return candidate.text();
    }
  }
  return std::nullopt;
}

std::string help_topic_names() {
  std::string names;
  for (const HelpTopic& topic : topics) {
    names += topic.name.empty() ? "" : fmt::format("{}`{}`", names.empty() ? "" : ", ", topic.name);
  }
  return names;
}

}  // namespace mbcc
