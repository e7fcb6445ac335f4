#!/usr/bin/env python3
"""A planner for docs/planner_protocol.md: each member goes to the nearest cell that nobody has seen yet.

Ways are found on the search cells, from each to its eight neighbours, where the straight line between them is free.
"""
import heapq
import json
import math
import sys


class World:
    def __init__(self, message):
        self.points = [(x, y) for x, y, _ in message["cells"]]
        self.size, self.corner = message["cell_size_m"], message["cells_corner_in_map"]
        self.layers = message["layers"]
        self.at = {self.block(point): i for i, point in enumerate(self.points)}

    def block(self, point):
        return tuple(math.floor((p - c) / self.size) for p, c in zip(point, self.corner))

    def is_free(self, layer, a, b, margin):
        """Whether a body passes from a to b: samples along the line, and around it."""
        rows, cell = self.layers[layer]["rows"], self.layers[layer]["resolution_m"]
        corner = self.layers[layer]["corner_in_map"]
        steps = max(1, math.ceil(math.dist(a, b) / (0.5 * cell)))
        for i in range(steps + 1):
            x = a[0] + (b[0] - a[0]) * i / steps - corner[0]
            y = a[1] + (b[1] - a[1]) * i / steps - corner[1]
            for dx, dy in ((0, 0), (margin, 0), (-margin, 0), (0, margin), (0, -margin)):
                if rows[math.floor((y + dy) / cell)][math.floor((x + dx) / cell)] != ".":
                    return False
        return True

    def way(self, member, is_goal):
        """The cheapest way from where the member's plan begins to a cell that is a goal; that alone if there is none."""
        start = tuple(member["committed"][-1][1:] if member["committed"] else member["pose"][:2])
        open_list, done = [(0.0, start, (start,))], set()
        while open_list:
            cost, here, way = heapq.heappop(open_list)
            if here in done:
                continue
            done.add(here)
            if len(way) > 1 and is_goal(self.at[self.block(here)]):
                return way
            bx, by = self.block(here)
            for block in ((bx + dx, by + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)):
                there = self.points[self.at[block]] if block in self.at else None
                margin = member["radius_m"] if here != start else self.layers[member["layer"]]["resolution_m"]
                if there and there not in done and self.is_free(member["layer"], here, there, margin):
                    heapq.heappush(open_list, (cost + math.dist(here, there), there, way + (there,)))
        return (start,)


def timed(way, speed, committed):
    path = list(committed) or [[0.0, *way[0]]]
    for here, there in zip(way, way[1:]):
        path.append([path[-1][0] + math.dist(here, there) / speed, *there])
    return path


world = None
for line in sys.stdin:
    message = json.loads(line)
    if message["type"] == "world":
        world = World(message)
        continue
    mass, taken, paths = message["masses"][0], set(), []
    for member in message["members"]:
        way = world.way(member, lambda cell: mass[cell] > 0.0 and cell not in taken)
        taken.update(i for i, p in enumerate(world.points) if math.dist(p, way[-1]) <= member["view_max_m"])
        paths.append(timed(way, member["speed_mps"], member["committed"]))
    print(json.dumps({"paths": paths}), flush=True)
