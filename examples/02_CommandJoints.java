// 02 Command joints: a whole controller in Java.  It holds the posture it finds, with the torque that held it.
//
//   eval "$(./twinbus env)"
//   java -Djava.net.preferIPv4Stack=true -cp "$CLASSPATH" examples/02_CommandJoints.java

import java.security.SecureRandom;
import lcm.lcm.*;
import twinbus.joint_command_t;
import twinbus.robot_state_t;
import twinbus.source_status_t;

public class CommandJoints implements LCMSubscriber {
  // Of hrp1s: first joint, last joint, kp [N m/rad], kd [N m s/rad].
  static final int[][] GAINS = {{0, 5, 15000, 300}, {6, 9, 3000, 60}, {10, 12, 600, 6}, {13, 18, 15000, 300},
    {19, 22, 3000, 60}, {23, 25, 600, 6}, {26, 28, 15000, 300}};
  final joint_command_t command = new joint_command_t();
  boolean holding = false, told = false;  long stopped = 0;

  // The first run of anything takes Java tens of milliseconds, longer than a robot waits for a command.
  void warm_up(LCM lcm) throws java.io.IOException {
    LCMDataOutputStream out = new LCMDataOutputStream();
    new robot_state_t().encode(out);
    for (int i = 0; i < 2000; ++i) {
      new robot_state_t(new LCMDataInputStream(out.getBuffer(), 0, out.size()));
      lcm.publish("WARM_UP", command);
    }
  }

  void hear(source_status_t status) {
    boolean other = status.role == 2 && status.controller_id != 0 && status.controller_id != command.controller_id;
    if (other && !told) System.out.println("CommandJoints: NOT OBEYED, another controller is; end it, then ./twinbus clear");
    told = other;
  }
  public void messageReceived(LCM lcm, String channel, LCMDataInputStream in) {
    try {
      if (channel.equals("SOURCE_STATUS")) { hear(new source_status_t(in)); return; }
      robot_state_t state = new robot_state_t(in);
      if (!holding) { command.q = state.q.clone(); command.tau = state.tau.clone(); stopped = state.time_ns; holding = true; }
      if (state.stop_kind != 1) stopped = state.time_ns;  // a balanced stop: it rests by itself for half a second, then is held
      command.flags = (short) (state.time_ns > stopped && state.time_ns - stopped < 500000000L ? 1 : 0);
      command.tick = state.tick;  // which tick, source, term and robot this answers
      command.run_id = state.run_id; command.term = state.term;
      command.model_hash = state.model_hash; command.joint_count = state.joint_count;
      lcm.publish("COMMAND", command);
    } catch (java.io.IOException error) {
      System.err.println("CommandJoints: " + error.getMessage());
    }
  }

  public static void main(String[] args) throws Exception {
    LCM lcm = LCM.getSingleton();  // $LCM_DEFAULT_URL
    CommandJoints self = new CommandJoints();
    self.command.controller_id = 1 + (new SecureRandom().nextLong() & ((1L << 53) - 2));
    for (int[] g : GAINS) for (int j = g[0]; j <= g[1]; ++j) { self.command.kp[j] = g[2]; self.command.kd[j] = g[3]; }
    self.warm_up(lcm);
    lcm.subscribe("STATE", self); lcm.subscribe("SOURCE_STATUS", self);
    System.out.println("CommandJoints: ready"); Thread.sleep(Long.MAX_VALUE);
  }
}
