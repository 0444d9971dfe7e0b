#!/usr/bin/env python3
"""A billy goat, 0.75 m at the withers: horns swept back, ears, beard, cloven feet, a short tail: examples/goat.sinew."""
from skeleton import Skeleton, spline


def trunk(s):
    """From the chest back to the rump and the raised tail."""
    chest = s.node(None, (0, -0.28, 0.62), 0.135, "chest")
    *_, rump = s.chain(chest, [(0, -0.1, 0.575, 0.155), (0, 0.1, 0.57, 0.16), (0, 0.3, 0.625, 0.125)], "back")
    s.chain(rump, [(0, 0.435, 0.69, 0.045), (0, 0.485, 0.765, 0.034), (0, 0.475, 0.83, 0.022)], "tail")
    return chest, rump


def head(s, chest):
    """Neck, skull with horns and ears, muzzle, beard."""
    *_, skull = s.chain(chest, [(0, -0.42, 0.79, 0.085), (0, -0.49, 0.915, 0.07), (0, -0.55, 1.015, 0.072)], "neck")
    muzzle = s.chain(skull, [(0, -0.65, 0.975, 0.053), (0, -0.735, 0.925, 0.042)], "muzzle")
    s.chain(muzzle[0], [(0, -0.655, 0.885, 0.026), (0, -0.645, 0.82, 0.02), (0, -0.63, 0.755, 0.008)], "beard", type="cone")
    curve = [(0.035, -0.52, 1.105, 0.032), (0.055, -0.475, 1.2, 0.028), (0.095, -0.385, 1.275, 0.023),
             (0.15, -0.27, 1.29, 0.017), (0.2, -0.175, 1.245, 0.01)]
    s.chain(skull, spline(curve, 7), "horn", type="cone")
    s.chain(skull, [(0.1, -0.53, 1.025, 0.022), (0.155, -0.52, 0.99, 0.027), (0.2, -0.515, 0.945, 0.01)], "ear", scale=[0.5, 1.3], type="cone")


def hoof(s, ankle, x, y):
    for name, side in (("outer toe", 1), ("inner toe", -1)):
        s.chain(ankle, [(x + 0.02 * side, y - 0.042, 0.024, 0.02)], name)


def legs(s, chest, rump):
    *_, ankle = s.chain(chest, [(0.085, -0.265, 0.5, 0.072), (0.095, -0.235, 0.37, 0.044), (0.095, -0.265, 0.235, 0.034),
                                (0.095, -0.255, 0.1, 0.023), (0.095, -0.27, 0.06, 0.026)], "foreleg")
    hoof(s, ankle, 0.095, -0.27)
    *_, ankle = s.chain(rump, [(0.09, 0.285, 0.51, 0.095), (0.105, 0.235, 0.385, 0.06), (0.105, 0.36, 0.265, 0.036),
                               (0.1, 0.335, 0.11, 0.024), (0.1, 0.32, 0.06, 0.026)], "hindleg")
    hoof(s, ankle, 0.1, 0.32)


def main():
    s = Skeleton(mirrored=True)
    chest, rump = trunk(s)
    head(s, chest)
    legs(s, chest, rump)
    s.save("goat")


if __name__ == "__main__":
    main()
