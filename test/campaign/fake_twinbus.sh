#!/bin/sh
# Stands in for `twinbus run`: a report by seed and settings, at once.
#   --set bad=N: seeds that N divides fail; --set limit=X --set push=Y: fails when Y > X; --set do=hang, crash or nothing: does so;
#   --set ms=N: takes N ms.
report='' log='' seed=1 bad=0 push=0 limit=1e9 ms=0
shift; scene=$1; shift
while [ $# -gt 0 ]; do
  case $1 in
    --seed) seed=$2; shift ;;
    --report) report=$2; shift ;;
    --log) log=$2; shift ;;
    --set)
      case $2 in
        bad=*) bad=${2#bad=} ;;
        push=*) push=${2#push=} ;;
        limit=*) limit=${2#limit=} ;;
        ms=*) ms=${2#ms=} ;;
        do=hang) sleep 60 ;;
        do=crash) kill -SEGV $$ ;;
        do=nothing) exit 0 ;;
        *) echo "run: no setting '${2%%=*}'; use bad" >&2; exit 2 ;;
      esac
      shift ;;
    --no-guard) ;;
    *) shift ;;
  esac
  shift
done
[ "$ms" = 0 ] || sleep "$(printf '0.%03d' "$ms")"
passed=true failures='[]'
if [ "$bad" != 0 ] && [ $((seed % bad)) -eq 0 ]; then passed=false failures='["the robot fell"]'; fi
if [ "$push" != 0 ] && awk "BEGIN {exit !($push > $limit)}"; then passed=false failures='["the robot fell"]'; fi
[ -z "$log" ] || echo log >"$log"
fell=true; [ $passed = false ] || fell=false
echo "{\"ticks\": 100, \"fell\": $fell, \"max_tilt_deg\": 0.$seed, \"state_hash\": \"hash$seed\", \"wall_s\": 0.0$$, \"simd\": \"${TWINBUS_SIMD:-avx2}\", \"failures\": $failures}" >"$report"
[ $passed = true ]
