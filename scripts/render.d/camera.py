# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a cut, the same for all frames."""

import numpy as np


class Camera:
    """A parallel projection along the blade's edge, obliquely."""

    def __init__(self, frames, angles):
        across, along = np.tan(np.radians(angles))
        up = np.array([0, 1, 0])
        self.towards = np.array([0, 0, 1])
        if frames[0].cells.shape[1] not in (4, 9):
            direction, normal = blade_axes(frames)
            edge = np.cross(normal, direction)
            up = -direction if abs(edge[2]) > 0.9 else np.eye(3)[2]
            # The normal, or another positive way, goes to the right.
            right = np.cross(up, edge)
            if right @ normal + 0.1 * right.sum() < 0:
                edge = -edge
            # A level cut is seen from above.
            side = normal if abs(normal[2]) > 0.9 else -normal
            self.towards = unit(edge + across * side - along * direction)
        self.right = unit(np.cross(up, self.towards))
        self.up = np.cross(self.towards, self.right)

    def project(self, points):
        points = np.atleast_2d(points)
        return np.stack([points @ self.right, points @ self.up], axis=1)

    def fit(self, points, size):
        flat = self.project(points)
        low, high = flat.min(axis=0), flat.max(axis=0)
        self.centre = (low + high) / 2
        self.half_height = 0.53 * max(high[1] - low[1],
                                      (high[0] - low[0]) * size[1] / size[0])
        self.focus = self.centre @ np.array([self.right, self.up])
        depths = points @ self.towards
        self.focus = self.focus + self.towards * depths.mean()
        self.distance = 2 * np.ptp(depths) + 4 * self.half_height

    def pixels(self, points):
        """In units of the picture's height from its centre, y upwards."""
        offset = (self.project(points) - self.centre) / (2 * self.half_height)
        return offset.tolist()

    def window(self, points):
        """(left, right, below, above) of what is seen."""
        flat = np.array(self.pixels(points))
        low, high = flat.min(axis=0), flat.max(axis=0)
        return [low[0], high[0], low[1], high[1]]

    def aim(self, camera):
        camera.ParallelProjectionOn()
        camera.SetParallelScale(self.half_height)
        camera.SetFocalPoint(self.focus)
        camera.SetPosition(self.focus + self.distance * self.towards)
        camera.SetViewUp(self.up)


def blade_axes(frames):
    """The first blade's direction and the cut's normal; without one, from above."""
    for frame in frames:
        if frame.has_blade:
            direction = unit(frame.facts["blade_direction"][0])
            normal = frame.facts["cut_normal"][0]
            normal = normal - np.dot(normal, direction) * direction
            if np.linalg.norm(normal) > 1e-6:
                # Which wall it points from is the mesh's chance.
                normal = unit(normal)
                largest = np.argmax(np.abs(normal))
                return direction, normal * np.sign(normal[largest])
    return np.array([0.0, 0.0, -1.0]), np.array([0.0, 1.0, 0.0])


def unit(vector):
    return vector / np.linalg.norm(vector)
