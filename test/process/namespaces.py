"""Network namespaces joined by a switch: several machines on one cable, on one machine.

    with Cable() as cable:
        a = cable.machine('10.77.0.1')
        process = a.start(['bus_probe', ...])

Needs to run as root of some network namespace (tools/private_bus.sh gives one).
"""
import itertools
import subprocess

URL = 'udpm://239.255.76.67:17667?ttl=1'
NUMBERS = itertools.count()  # a namespace goes away some time after its last process, and its cables with it


def run(*words):
    subprocess.run(words, check=True)


class Machine:
    """A network namespace, kept alive by a sleeping process."""

    def __init__(self, bridge, number, address):
        self.address = address
        self.keeper = subprocess.Popen(['unshare', '--net', 'sh', '-c', 'echo ready; exec sleep 120'],
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.keeper.stdout.readline()
        outside, inside = f'tbo{number}', f'tbi{number}'
        run('ip', 'link', 'add', outside, 'type', 'veth', 'peer', 'name', inside)
        run('ip', 'link', 'set', inside, 'netns', str(self.keeper.pid))
        run('ip', 'link', 'set', outside, 'master', bridge, 'up')
        self.run('ip', 'link', 'set', 'lo', 'up')
        self.run('ip', 'address', 'add', address + '/24', 'dev', inside)
        self.run('ip', 'link', 'set', inside, 'up')
        self.run('ip', 'route', 'add', '224.0.0.0/4', 'dev', inside)

    def command(self, words):
        return ['nsenter', '--net=/proc/%d/ns/net' % self.keeper.pid, *words]

    def run(self, *words):
        run(*self.command(words))

    def start(self, words, **options):
        options.setdefault('stdout', subprocess.PIPE)
        return subprocess.Popen(self.command(words), text=True, **options)

    def close(self):
        self.keeper.kill()
        self.keeper.communicate()


class Cable:
    def __enter__(self):
        self.machines = []
        self.bridge = f'tbr{next(NUMBERS)}'
        # Snooping would keep multicast back until somebody asked a router that is not there.
        run('ip', 'link', 'add', self.bridge, 'type', 'bridge', 'mcast_snooping', '0')
        run('ip', 'link', 'set', self.bridge, 'up')
        return self

    def machine(self, address):
        machine = Machine(self.bridge, next(NUMBERS), address)
        self.machines.append(machine)
        return machine

    def __exit__(self, *_):
        for machine in self.machines:
            machine.close()
        subprocess.run(['ip', 'link', 'delete', self.bridge], check=False)
