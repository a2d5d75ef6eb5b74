"""ONNX files of a few nodes, written with the standard library: protocol buffers by hand.

    linear(path, reads, moves, bias)    action = 0 * observation + bias
    slow=N                              N products of matrices of 500 x 500 before the action
    tables={name: rows}                 row time_step of each is an output too; from the last one on it stays
"""
import struct

FLOAT, INT64 = 1, 7


def _varint(value):
    out = b''
    while True:
        byte, value = value & 0x7F, value >> 7
        out += bytes([byte | (0x80 if value else 0)])
        if not value:
            return out


def _bytes(field, data):
    data = data.encode() if isinstance(data, str) else data
    return _varint(field << 3 | 2) + _varint(len(data)) + data


def _number(field, value):
    return _varint(field << 3) + _varint(value)


def _tensor(name, shape, numbers):
    return b''.join(_number(1, size) for size in shape) + _number(2, FLOAT) + _bytes(8, name) + \
        _bytes(9, struct.pack(f'<{len(numbers)}f', *numbers))


def _node(kind, inputs, outputs, **whole):
    return b''.join(_bytes(1, name) for name in inputs) + b''.join(_bytes(2, name) for name in outputs) + _bytes(4, kind) + \
        b''.join(_bytes(5, _bytes(1, name) + _number(3, value) + _number(20, 2)) for name, value in whole.items())


def _value(name, shape):
    dims = b''.join(_bytes(1, _number(1, size)) for size in shape)
    return _bytes(1, name) + _bytes(2, _bytes(1, _number(1, FLOAT) + _bytes(2, dims)))


def linear(path, reads, moves, bias=0.0, slow=0, metadata=(), inputs=(), output='actions', tables=None):
    """inputs: further ones, as (name, shape)."""
    graph = [_bytes(1, _node('MatMul', ['obs', 'weight'], ['product']))]
    tensors = [_bytes(5, _tensor('weight', [reads, moves], [0.0] * (reads * moves))), _bytes(5, _tensor('bias', [moves], [bias] * moves))]
    last = 'product'
    if slow:
        tensors += [_bytes(5, _tensor('large', [500, 500], [1e-3] * 250000)), _bytes(5, _tensor('nothing', [1], [0.0]))]
        graph += [_bytes(1, _node('ReduceSum', ['product'], ['seed'])), _bytes(1, _node('Add', ['large', 'seed'], ['m0']))]
        graph += [_bytes(1, _node('MatMul', [f'm{k}', 'large'], [f'm{k + 1}'])) for k in range(slow)]
        graph += [_bytes(1, _node('ReduceMean', [f'm{slow}'], ['mean'])), _bytes(1, _node('Mul', ['mean', 'nothing'], ['zero'])),
                  _bytes(1, _node('Add', ['product', 'zero'], ['late']))]
        last = 'late'
    graph += [_bytes(1, _node('Add', [last, 'bias'], [output]))]
    outputs = []
    if tables:
        inputs = [*inputs, ('time_step', [1, 1])]
        count = len(next(iter(tables.values())))
        tensors.append(_bytes(5, _tensor('last', [1], [float(count - 1)])))
        graph += [_bytes(1, _node('Min', ['time_step', 'last'], ['bounded'])), _bytes(1, _node('Cast', ['bounded'], ['row'], to=INT64))]
        for name, rows in tables.items():
            tensors.append(_bytes(5, _tensor(f'{name}_table', [count, len(rows[0])], [number for row in rows for number in row])))
            graph.append(_bytes(1, _node('Gather', [f'{name}_table', 'row'], [name])))
            outputs.append(_bytes(12, _value(name, [1, 1, len(rows[0])])))
    ends = [_bytes(11, _value('obs', [1, reads]))] + [_bytes(11, _value(name, shape)) for name, shape in inputs] + \
           [_bytes(12, _value(output, [1, moves]))] + outputs
    body = b''.join(graph) + _bytes(2, 'tiny') + b''.join(tensors) + b''.join(ends)
    model = _number(1, 8) + _bytes(7, body) + _bytes(8, _bytes(1, '') + _number(2, 11)) + \
        b''.join(_bytes(14, _bytes(1, key) + _bytes(2, value)) for key, value in metadata)
    path.write_bytes(model)
    return path
