#include "precision/problems.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "precision/program.hpp"

namespace bench::precision {

namespace {

// End states in 113 bits by extrapolation (Gragg, Bulirsch, Stoer) at two settings that agree to 1e-22 or better;
// Kepler's by his equation, that of the paper's example in closed form.

// All coordinates, then all speeds.
constexpr double kepler[] = {4.00000000000000022204e-01, -5.15322727806381049695e-13, 0,
                             1.61038352439494060150e-12, 1.99999999999999999999e+00,  0};

constexpr double henon_heiles[] = {1.04625301290831348545e-01, 4.32949136898116790649e-01, 3.24261632664620684047e-01,
                                   -2.05074895958261765836e-02};

constexpr double outer_solar_system[] = {
    1.23584254235460867641e+00,  -4.89943821144274905258e-01, -2.46105361814321276981e-01, 2.61107957011290519851e+00,
    -5.07952549678797411343e+00, -2.24472067785305275394e+00, -7.66913624739120423125e+00, -4.05205224548808816804e+00,
    -1.33111566971149458992e+00, -5.82474394984775420821e+00, 1.53371737535725179696e+01,  6.78246340991760653921e+00,
    2.06639802475150347867e+01,  2.05829560424598542926e+01,  7.89479541474819729461e+00,  3.65669506988225005423e+01,
    -1.37676844012597724150e+01, -1.50434692218232783954e+01, -9.13437558160835789064e-07, -3.23773810609494083158e-06,
    -1.40208020312685005306e-06, 7.17887892837591578328e-03,  2.23357952607035356731e-03,  7.83748342939335586189e-04,
    1.84479095624688210779e-03,  -4.77280688348912564306e-03, -2.05657904992822766533e-03, -3.65895005716157481456e-03,
    -1.55480383369646797890e-03, -6.29514555304220590781e-04, -2.39287456607262107301e-03, 1.89046968181190663109e-03,
    8.33321369757218348992e-04,  1.62992924842465636140e-03,  2.10801156027822597207e-03,  1.68504842994412212809e-04};

constexpr double pendulum_to_100[] = {2.28446050937144617760e-01,  3.61107794859579493281e-01,
                                      -9.04109264581928407752e-01, -6.86427609162346574463e-01,
                                      1.54139517089545445728e+00,  4.42201125753058342239e-01};

/// All components of a state from the first on.
std::vector<Known> known(std::span<const double> values, std::size_t first = 0) {
  std::vector<Known> all;
  for (std::size_t j = 0; j < values.size(); ++j) {
    all.push_back({first + j, values[j]});
  }
  return all;
}

/// The position of one particle of three coordinates, counted from 0.
std::vector<Known> position(std::size_t particle, const std::array<double, 3>& values) {
  return known(values, 3 * particle);
}

std::vector<Problem> particles() {
  return {{"kepler", "kepler", "Kepler, eccentricity 0.6, 100 revolutions", 628.31853071795865, known(kepler)},
          {"henon_heiles", "henon_heiles", "Henon and Heiles, to 1000", 1000, known(henon_heiles)},
          {"outer_solar_system", "outer_solar_system", "outer solar system, 200,000 days", 200000,
           known(outer_solar_system)}};
}

std::vector<Problem> constrained() {
  std::vector<Problem> all = {
      {"pendulum_100", "spherical_pendulum", "spherical pendulum, 100 s", 100, known(pendulum_to_100)},
      {"pendulum", "spherical_pendulum", "spherical pendulum, 10 s", 10,
       position(0, {-4.6625812033662846748e-02, 4.0419188477692619593e-01, -9.1348505950161965578e-01})}};
  for (const std::size_t links : {3u, 10u, 200u}) {
    const Scene scene = chain(links);
    all.push_back({scene.model, scene.model, std::to_string(links) + " links",
                   scene.step * static_cast<double>(scene.steps), scene.end});
  }
  all.insert(all.end() - 1, {"chain_50", "chain_50", "50 links", 1,
                             position(49, {37.194199475897795, 1.4622913266693005, -32.800649606923301})});
  const Scene paper = paper_example();
  all.push_back({"artigo5", "artigo5", "the paper's example", 5, paper.end});
  all.push_back({"four_bar", "four_bar", "four-bar, 10 s", 10,
                 known(std::array{9.1287807115288875109e-01, 4.0823232014158479982e-01, 2.3112761109658911590,
                                  2.4805457429247198250})});
  all.push_back({"closed_ring", "closed_ring", "closed ring of 12, 2 s", 2,
                 position(6, {7.3285625372243178925e-01, -2.9596573944067833581e-01, -3.8359873233732979993})});
  return all;
}

/// Models of the literature, which the tests have with their end states: all coordinates are watched.
std::vector<Problem> published() {
  std::ifstream file(BENCH_PUBLISHED "/references.json");
  const nlohmann::json references = nlohmann::json::parse(file);
  std::vector<Problem> all;
  for (const char* const model : {"iftomm_a01_pendulum", "ivp_caraxis", "ivp_andrews", "ivp_pleiades", "ivp_fekete_t10",
                                  "knife_edge", "uk_surface"}) {
    const nlohmann::json& reference = references.at(model);
    const std::vector<std::string> names = program_of(model).value().names;
    Problem problem{model, model, reference.at("problem"), reference.at("time"), {}};
    for (std::size_t j = 0; j < names.size() / 2; ++j) {
      problem.end.push_back({j, reference.at("end").at(names[j])});
    }
    all.push_back(std::move(problem));
  }
  return all;
}

}  // namespace

std::vector<Problem> problems() {
  std::vector<Problem> all = particles();
  for (std::vector<Problem> more : {constrained(), published()}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace bench::precision
