"""The view of a cut, the same for all frames."""

import numpy as np
from blade import unit


class Camera:
    """A parallel projection along the blade's edge, obliquely."""

    def __init__(self, blade, angles):
        across, along = np.tan(np.radians(angles))
        up = np.array([0, 1, 0])
        self.towards = np.array([0, 0, 1])
        if blade.dimension == 3:
            edge = blade.edge if blade.edge.sum() > 0 else -blade.edge
            # A level cut is seen from above.
            side = blade.normal if blade.axis == 2 else -blade.normal
            self.towards = unit(edge + across * side -
                                along * blade.direction)
            up = -blade.direction if abs(edge[2]) > 0.9 else np.eye(3)[2]
        self.right = unit(np.cross(up, self.towards))
        self.up = np.cross(self.towards, self.right)

    def project(self, points):
        points = np.atleast_2d(points)
        return np.stack([points @ self.right, points @ self.up], axis=1)

    def fit(self, points, size):
        low, high = self.project(points).min(axis=0), \
            self.project(points).max(axis=0)
        self.centre = (low + high) / 2
        self.half_height = 0.53 * max(high[1] - low[1],
                                      (high[0] - low[0]) * size[1] / size[0])
        self.focus = self.centre @ np.array([self.right, self.up])
        self.distance = 10 * self.half_height + np.abs(points).max() * 4

    def pixels(self, points):
        """In units of the picture's height from its centre, y upwards."""
        offset = (self.project(points) - self.centre) / (2 * self.half_height)
        return offset.tolist()

    def aim(self, view):
        view.CameraParallelProjection = 1
        view.CameraParallelScale = self.half_height
        view.CameraFocalPoint = list(self.focus)
        view.CameraPosition = list(self.focus + self.distance * self.towards)
        view.CameraViewUp = list(self.up)
