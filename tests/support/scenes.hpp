#pragma once
// Scenes that several back-end tests look at.

#include <fmt/format.h>

#include <string>

namespace mbcc::test {

/// Point masses on massless links, hanging from the origin: a band of constraints, each touching the next.
inline std::string chain(int links) {
  return fmt::format(R"(dimension 3
constant N = {}
for i in 1..N {{ particle p[i] {{ mass = i; position = (i, 0, 0); velocity = (0, 0, 0.1*i) }} }}
gravity (0, 0, -9.81)
constraint first : norm(p[1].position)^2 = 1
for i in 2..N {{ constraint link[i] : norm(p[i].position - p[i - 1].position)^2 = 1 }}
)",
                     links);
}

/// A hub that rods join to every one of so many weights: eliminating it first would couple all of them.
inline std::string wheel(int spokes) {
  return fmt::format(R"(dimension 2
constant N = {}
particle hub {{ mass = 10; position = (0, 0) }}
for i in 1..N {{ particle p[i] {{ mass = 1; position = (cos(i), sin(i)) }} }}
for i in 1..N {{ constraint rod[i] : norm(p[i].position - hub.position) = 1 }}
gravity (0, -9.81)
)",
                     spokes);
}

/// A net of so many by so many weights, joined to their neighbours.
inline std::string net(int side) {
  return fmt::format(R"(dimension 3
constant N = {}
for i in 1..N {{ for j in 1..N {{ particle p[i, j] {{ mass = 1; position = (i, j, 0) }} }} }}
gravity (0, 0, -9.81)
for i in 1..N {{ for j in 1..N - 1 {{ constraint along[i, j] : norm(p[i, j + 1].position - p[i, j].position)^2 = 1 }} }}
for i in 1..N {{ constraint held[i] : p[i, 1].z = 0 }}
)",
                     side);
}

/// Bodies that attract each other, without constraints.
inline std::string cluster(int bodies) {
  return fmt::format(R"(dimension 3
constant N = {}
parameter G = 1
for i in 1..N {{ particle p[i] {{ mass = i; position = (cos(i), sin(2*i), i); velocity = (0, 0.1, 0) }} }}
for i in 1..N {{
  force on p[i] = sum(j in 1..N, if(j != i, G*i*j*(p[j].position - p[i].position)/norm(p[j].position - p[i].position)^3, (0, 0, 0)))
}}
)",
                     bodies);
}

/// Particles on springs of their own, without constraints.
inline std::string springs(int particles) {
  return fmt::format(R"(dimension 2
constant N = {}
parameter k = 3
for i in 1..N {{ particle p[i] {{ mass = i; position = (i, 0); force = (-k*p[i].x*sin(t), -k*p[i].y*cos(t)) }} }}
)",
                     particles);
}

}  // namespace mbcc::test
