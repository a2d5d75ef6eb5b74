// A whole controller in Java: holds the posture it finds, with the torque that held it.
//
//   eval "$(./twinbus env)"
//   java -Djava.net.preferIPv4Stack=true -cp "$CLASSPATH" test/clients/Hold.java [FIRST-LAST:KP:KD,...]
//
// Knows STATE and COMMAND and nothing else.

import java.security.SecureRandom;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMDataOutputStream;
import lcm.lcm.LCMSubscriber;
import twinbus.joint_command_t;
import twinbus.robot_state_t;

public class Hold implements LCMSubscriber {
  static final String HRP1S =
      "0-5:15000:300,6-9:3000:60,10-12:600:6,13-18:15000:300,19-22:3000:60,23-25:600:6,26-28:15000:300";

  final joint_command_t command = new joint_command_t();
  boolean holding = false;

  Hold(String gains) {
    command.controller_id = 1 + (new SecureRandom().nextLong() & ((1L << 53) - 2));
    for (String entry : gains.split(",")) {
      String[] parts = entry.split(":");
      String[] joints = parts[0].split("-");
      for (int j = Integer.parseInt(joints[0]); j <= Integer.parseInt(joints[joints.length - 1]); ++j) {
        command.kp[j] = Float.parseFloat(parts[1]);
        command.kd[j] = Float.parseFloat(parts[2]);
      }
    }
  }

  // The first run of anything takes Java tens of milliseconds, longer than a robot waits for a command.
  void warm_up(LCM lcm) throws java.io.IOException {
    LCMDataOutputStream out = new LCMDataOutputStream();
    new robot_state_t().encode(out);
    for (int i = 0; i < 2000; ++i) {
      new robot_state_t(new LCMDataInputStream(out.getBuffer(), 0, out.size()));
      lcm.publish("HOLD_WARM_UP", command);
    }
  }

  @Override
  public void messageReceived(LCM lcm, String channel, LCMDataInputStream in) {
    try {
      robot_state_t state = new robot_state_t(in);
      if (!holding) {
        holding = true;
        command.q = state.q.clone();
        command.tau = state.tau.clone();
        System.out.println("Hold: holding " + state.joint_count + " joints");
      }
      // Which tick, source, term and robot this answers.
      command.tick = state.tick;
      command.run_id = state.run_id;
      command.term = state.term;
      command.model_hash = state.model_hash;
      command.joint_count = state.joint_count;
      lcm.publish("COMMAND", command);
    } catch (java.io.IOException error) {
      System.err.println("Hold: " + error.getMessage());
    }
  }

  public static void main(String[] args) throws Exception {
    LCM lcm = LCM.getSingleton();  // $LCM_DEFAULT_URL
    Hold hold = new Hold(args.length > 0 ? args[0] : HRP1S);
    hold.warm_up(lcm);
    lcm.subscribe("STATE", hold);
    System.out.println("Hold: ready");
    Thread.sleep(Long.MAX_VALUE);
  }
}
