#!/bin/sh
# 15 A chart: numbers of a log as SVG and CSV, without a program.
#
#   examples/15_chart.sh LOG [FOLDER] [TWINBUS]    (FOLDER: where to, default .; TWINBUS: default ./twinbus)
set -eu
log=$1 folder=${2:-.} twinbus=${3:-./twinbus}
"$twinbus" log plot "$log" STATE.q.LLEG_KNEE,COMMAND.q.LLEG_KNEE 'STATE.wrench[0]' --out "$folder/knee.svg"
"$twinbus" log csv "$log" CONTROLLER_STATUS "$folder/balance.csv" --fields tick,com,zmp,zmp_margin
