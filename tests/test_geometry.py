"""Laws of poses and matrices."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.geometry import (
    apply,
    inverse,
    joint_matrix,
    look_at,
    lowest_highest,
    matrix,
    quat_from_axis_angle,
    quat_from_matrix,
    quat_from_yaw,
    rotation_matrix,
    round_position,
    round_quat,
    yaw_of,
)

number = st.floats(-5, 5, allow_nan=False)
angle = st.floats(-3.1, 3.1, allow_nan=False)
axis = st.tuples(number, number, number).filter(lambda v: math.hypot(*v) > 0.1)


@given(axis, angle)
def test_rotation_is_orthonormal_and_matrix_round_trips(direction, turn):
    rotation = rotation_matrix(quat_from_axis_angle(direction, turn))
    assert np.allclose(rotation @ rotation.T, np.eye(3))
    assert np.isclose(np.linalg.det(rotation), 1)
    assert np.allclose(rotation_matrix(quat_from_matrix(rotation)), rotation)


@given(axis, angle, st.tuples(number, number, number))
def test_inverse_undoes_a_pose(direction, turn, position):
    pose = matrix(position, quat_from_axis_angle(direction, turn))
    points = [(0.1, 0.2, 0.3), (1, -1, 2)]
    assert np.allclose(apply(inverse(pose), apply(pose, points)), points)


@given(angle)
def test_yaw_round_trips(turn):
    assert yaw_of(quat_from_yaw(turn)) == pytest.approx(turn, abs=1e-9)


@given(axis, angle)
def test_rounding_a_quaternion_twice_changes_nothing(direction, turn):
    once = round_quat(quat_from_axis_angle(direction, turn))
    again = round_quat(once)
    assert np.allclose(once, again, atol=1.1e-6)
    assert once[3] >= 0


def test_rounded_positions_have_no_negative_zero():
    assert str(round_position((-0.000001, 1.234567, 0))) == "(0.0, 1.23457, 0.0)"


def test_a_hinge_keeps_its_origin_and_a_slide_shifts_along_its_axis():
    hinge = joint_matrix("revolute", (1, 2, 0), (0, 0, 1), 0.7)
    assert np.allclose(apply(hinge, [(1, 2, 5)]), [(1, 2, 5)])
    quarter = joint_matrix("revolute", (0, 0, 0), (0, 0, 1), math.pi / 2)
    assert np.allclose(apply(quarter, [(1, 0, 0)]), [(0, 1, 0)])
    slide = joint_matrix("prismatic", (9, 9, 9), (2, 0, 0), 0.3)
    assert np.allclose(apply(slide, [(1, 1, 1)]), [(1.3, 1, 1)])


def test_look_at_is_an_opencv_camera():
    pose = look_at((0, 0, 1), (2, 0, 1))
    assert np.allclose(pose[:3, 2], (1, 0, 0))  # z forward
    assert np.allclose(pose[:3, 1], (0, 0, -1))  # y down
    assert np.allclose(pose[:3, 0], (0, -1, 0))  # x right


def test_the_box_around_points_holds_their_extremes():
    low, high = lowest_highest(np.array([[0.0, 5.0, -1.0], [2.0, -3.0, 4.0], [1.0, 0.0, 0.0]]))
    assert low.tolist() == [0.0, -3.0, -1.0]
    assert high.tolist() == [2.0, 5.0, 4.0]
