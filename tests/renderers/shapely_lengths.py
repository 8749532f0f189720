"""Reads lines and shapes from stdin and prints how much of each line lies outside the shapes, by shapely.

Input: one item a line, in the order of drawing: "line x y x y ..." or "shape x y x y ...", a shape being a simple
polygon that hides what came before. Output: for each "line" the visible length in full precision.
"""
import sys

from shapely.geometry import LineString, Polygon, box

items = []
for row in sys.stdin:
    kind, *numbers = row.split()
    values = [float(n) for n in numbers]
    items.append((kind, list(zip(values[::2], values[1::2]))))

shapes = [(at, Polygon(points)) for at, (kind, points) in enumerate(items) if kind == "shape"]
for at, (kind, points) in enumerate(items):
    if kind != "line":
        continue
    left = LineString(points)
    for later, shape in shapes:
        if later > at and shape.intersects(left):
            left = left.difference(shape)
    print(repr(left.length))
