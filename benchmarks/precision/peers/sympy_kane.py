#!/usr/bin/env python3
"""sympy_kane.py LINKS OUT.hpp: an open chain by SymPy's KanesMethod, as C for benchmarks/precision/peers/kane.cpp.

Two angles for each link, whose rates are the speeds; mass matrix and forcing as expressions, common subexpressions taken
out, printed as C: what SymPy's documentation advises for speed."""

import sys

import sympy as sm
import sympy.physics.mechanics as me


def main():
    links, path = int(sys.argv[1]), sys.argv[2]
    q, u = me.dynamicsymbols(f"q:{2 * links}"), me.dynamicsymbols(f"u:{2 * links}")
    fixed = me.ReferenceFrame("N")
    origin = me.Point("O")
    origin.set_vel(fixed, 0)
    rates = [u[i] - q[i].diff() for i in range(2 * links)]
    bodies, loads, at = [], [], origin
    for k in range(links):
        a, b = q[2 * k], q[2 * k + 1]
        rod = -sm.sin(b) * fixed.x + sm.sin(a) * sm.cos(b) * fixed.y - sm.cos(a) * sm.cos(b) * fixed.z
        mass = at.locatenew(f"P{k}", rod)
        swap = dict(zip([x.diff() for x in q], u))
        mass.set_vel(fixed, at.vel(fixed) + rod.diff(me.dynamicsymbols._t, fixed).subs(swap))
        bodies.append(me.Particle(f"B{k}", mass, 1))
        loads.append((mass, -sm.Float("9.81") * fixed.z))
        at = mass
    kane = me.KanesMethod(fixed, q_ind=q, u_ind=u, kd_eqs=rates)
    kane.kanes_equations(bodies, loads)
    plain = {s: sm.Symbol(f"{'q' if s in q else 'u'}[{(q if s in q else u).index(s)}]") for s in q + u}
    size = 2 * links
    matrix = kane.mass_matrix.subs(plain)
    forcing = kane.forcing.subs(plain)
    lower = [matrix[i, j] for i in range(size) for j in range(i + 1)]
    common, results = sm.cse(lower + list(forcing))
    with open(path, "w") as out:
        out.write(f"inline void kane_equations(const double* q, const double* u, double (&m)[{size}][{size}], "
                  f"double (&f)[{size}]) {{\n")
        for symbol, value in common:
            out.write(f"  const double {symbol} = {sm.ccode(value)};\n")
        places = [f"m[{i}][{j}]" for i in range(size) for j in range(i + 1)] + [f"f[{i}]" for i in range(size)]
        for place, value in zip(places, results):
            out.write(f"  {place} = {sm.ccode(value)};\n")
        out.write("}\n")


main()
