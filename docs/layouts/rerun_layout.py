#!/usr/bin/env python3
"""A recording of one robot with a layout for Rerun: the force of a sensor, the robot's joints and its currents.

rerun_layout.py RUN.mcap RUN.rrd [ROBOT [SENSOR]]      then: rerun RUN.rrd

Needs the package rerun-sdk; looked at with 0.41.0. ROBOT is `arm` and SENSOR `wrist` where they are left out.
"""

import sys

import rerun as rr
import rerun.blueprint as rrb
from rerun.blueprint.encodings import ComponentSourceKind, VisualizerComponentMapping

WRENCH = "geometry_msgs.msg.WrenchStamped:message"
TICK = "mrroc_msgs.msg.ServoTick:message"


def lines(component, selector):
    """The numbers of one field of a message as lines."""
    return rr.SeriesLines().visualizer(mappings=[
        VisualizerComponentMapping("Scalars:scalars", ComponentSourceKind.SourceComponent, source_component=component, selector=selector)])


def plot(name, entity, component, selectors):
    return rrb.TimeSeriesView(origin=entity, contents=entity, name=name, overrides={entity: [lines(component, each) for each in selectors]})


def main():
    if not 3 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    recording, result = sys.argv[1:3]
    robot, sensor = sys.argv[3:] + ["arm", "wrist"][len(sys.argv) - 3:]
    blueprint = rrb.Blueprint(
        rrb.Vertical(
            plot("force, N", f"/{sensor}/wrench", WRENCH, [".wrench.force.x", ".wrench.force.y", ".wrench.force.z"]),
            rrb.TimeSeriesView(origin=f"/{robot}/joint_states/velocity", name="velocity, rad/s"),
            plot("current, A", f"/{robot}/servo", TICK, [".current[]"]),
        ),
        rrb.TimePanel(timeline="message_log_time"),
        collapse_panels=True,
    )
    rr.init("mrroc")
    rr.save(result, default_blueprint=blueprint)
    rr.log_file_from_path(recording)
    rr.disconnect()  # and waits for the file


if __name__ == "__main__":
    main()
