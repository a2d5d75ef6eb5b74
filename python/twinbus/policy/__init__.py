"""Learned policies as controllers: `./twinbus policy MODEL.onnx`.  What it was trained on is read (spec), bound by joint names (robot),
held against the robot and the network (check) and run on the bus (runner)."""
