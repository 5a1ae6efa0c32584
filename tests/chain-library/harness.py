import ctypes, sys, time

n, calls = 16, 100_000
rhs = ctypes.CDLL(sys.argv[1]).rhs
vector = ctypes.c_double * n
q, u, a = vector(*(0.1 * k for k in range(n))), vector(*[1.0] * n), vector()
start = time.perf_counter()
for _ in range(calls):
    rhs(q, u, a)
print(f"{1e9 * (time.perf_counter() - start) / calls:.0f} ns with the call", file=sys.stderr)
print(*a)
