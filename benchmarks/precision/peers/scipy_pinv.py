#!/usr/bin/env python3
"""scipy_pinv.py SCENE...: the equation of Udwadia and Kalaba with numpy's pinv, by SciPy's DOP853."""

import sys

import numpy as np
from scipy.integrate import solve_ivp

from scene import GRAVITY, Scene, measure


def rates_of(scene):
    masses = len(scene.positions)
    rods = masses + (scene.far is not None)
    near, far = np.zeros((1, 3)), np.reshape(scene.far or [], (-1, 3))
    free = np.tile([0, 0, -GRAVITY], masses)
    rows = np.arange(masses)

    def rates(_, state):
        r, v = state[:3 * masses].reshape(-1, 3), state[3 * masses:].reshape(-1, 3)
        rod = np.diff(np.concatenate((near, r, far)), axis=0)
        speed = np.diff(np.concatenate((near, v, np.zeros_like(far))), axis=0)
        a = np.zeros((rods, masses, 3))
        a[rows, rows] = rod[:masses]
        a[rows[:rods - 1] + 1, rows[:rods - 1]] = -rod[1:]
        a = a.reshape(rods, -1)
        b = -np.sum(speed * speed, axis=1)
        return np.concatenate((state[3 * masses:], free + np.linalg.pinv(a) @ (b - a @ free)))

    return rates


def main():
    for path in sys.argv[1:]:
        scene = Scene(path)
        rates, start = rates_of(scene), np.concatenate((np.ravel(scene.positions), np.ravel(scene.velocities)))

        def integrate(tolerance):
            solution = solve_ivp(rates, (0, scene.to), start, method="DOP853", rtol=tolerance, atol=tolerance)
            return solution.y[:len(start) // 2, -1].reshape(-1, 3)

        measure(scene, "SciPy, dop853 with pinv", [10.0 ** -k for k in range(3, 14)], integrate)


main()
