"""A scene file of mbcc_bench_precision --scenes, and the lines that a peer prints."""

import math
import pathlib
import sys
import time

PATIENCE = 1  # seconds: a contender whose run takes longer is not asked for more
GRAVITY = 9.81


class Scene:
    def __init__(self, path):
        self.name = pathlib.Path(path).stem
        self.positions, self.velocities, self.watched, self.far = [], [], [], None
        for line in open(path):
            word, *rest = line.split()
            numbers = [float(text) for text in rest]
            if word == "to":
                self.to = numbers[0]
            elif word == "mass":
                self.positions.append(numbers[:3])
                self.velocities.append(numbers[3:])
            elif word == "far":
                self.far = numbers
            elif word == "watch":
                self.watched.append((int(numbers[0]), int(numbers[1]), numbers[2]))
            else:
                sys.exit(f"{path}: `{word}` means nothing here")


def measure(scene, contender, settings, integrate, samples=3):
    """Prints the least time and the error of each setting; `integrate(setting)` gives the positions at the end."""
    for setting in settings:
        seconds = math.inf
        for _ in range(samples):
            begin = time.process_time()
            end = integrate(setting)
            seconds = min(seconds, time.process_time() - begin)
            if seconds > PATIENCE / 10:
                break
        error = max(abs(end[mass][axis] - value) for mass, axis, value in scene.watched)
        print(scene.name, contender, f"{setting:.3g}", f"{seconds:.4g}", f"{error:.3g}", sep="\t", flush=True)
        if seconds > PATIENCE:
            break
