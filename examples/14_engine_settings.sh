#!/bin/sh
# 14 Engine and settings: the same scene by both engines, with a heavier robot, softer soles, a late servo and noisy encoders.
#
#   examples/14_engine_settings.sh [TWINBUS]       (TWINBUS: default ./twinbus)
#
# twinbus_simulator --help lists every setting; in a scene they stand under `settings:`.
set -eu
twinbus=${1:-./twinbus}
"$twinbus" run sway --for 3
"$twinbus" run sway --for 3 --engine ode
"$twinbus" run sway --for 3 --set model.mass_scale=1.05 --set contact.stiffness_scale=0.5 --set servo.delay_ms=2
"$twinbus" run sway --for 3 --set sensor.noise.encoder=0.0001
