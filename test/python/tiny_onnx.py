"""ONNX files of a few nodes, written with the standard library: protocol buffers by hand.

    linear(path, reads, moves, bias)    action = 0 * observation + bias
    slow=N                              N products of matrices of 500 x 500 before the action
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


def _node(kind, inputs, outputs):
    return b''.join(_bytes(1, name) for name in inputs) + b''.join(_bytes(2, name) for name in outputs) + _bytes(4, kind)


def _value(name, shape):
    dims = b''.join(_bytes(1, _number(1, size)) for size in shape)
    return _bytes(1, name) + _bytes(2, _bytes(1, _number(1, FLOAT) + _bytes(2, dims)))


def linear(path, reads, moves, bias=0.0, slow=0, metadata=(), inputs=(), output='actions'):
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
    ends = [_bytes(11, _value('obs', [1, reads]))] + [_bytes(11, _value(name, shape)) for name, shape in inputs] + \
           [_bytes(12, _value(output, [1, moves]))]
    body = b''.join(graph) + _bytes(2, 'tiny') + b''.join(tensors) + b''.join(ends)
    model = _number(1, 8) + _bytes(7, body) + _bytes(8, _bytes(1, '') + _number(2, 11)) + \
        b''.join(_bytes(14, _bytes(1, key) + _bytes(2, value)) for key, value in metadata)
    path.write_bytes(model)
    return path
