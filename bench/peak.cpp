// The machine's peak for scale: single-precision multiply-adds a second, in registers, with the
// widest vectors that AVX2 has (without it, plain multiplies and adds).
//
//   bench_peak [THREADS]      prints GFLOP/s of one thread and of all
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace {

constexpr long turns = 20'000'000;
constexpr int chains =
    12;  // independent, to fill the pipelines: latency 4 times two units, and spare

#if defined(__x86_64__)
[[gnu::target("avx2,fma"), gnu::noinline]] float spin_fma(float seed) {
    __m256 sums[chains];
    for (int i = 0; i < chains; ++i) sums[i] = _mm256_set1_ps(seed + static_cast<float>(i));
    const __m256 a = _mm256_set1_ps(0.999999F);
    const __m256 b = _mm256_set1_ps(seed);
    for (long turn = 0; turn < turns; ++turn) {
#pragma GCC unroll 12
        for (int i = 0; i < chains; ++i) sums[i] = _mm256_fmadd_ps(sums[i], a, b);
    }
    float total = 0;
    for (const __m256& sum : sums) total += _mm256_cvtss_f32(sum);
    return total;
}
#endif

[[gnu::noinline]] float spin_plain(float seed) {
    float sums[chains];
    for (int i = 0; i < chains; ++i) sums[i] = seed + static_cast<float>(i);
    for (long turn = 0; turn < turns; ++turn) {
        for (float& sum : sums) sum = sum * 0.999999F + seed;
    }
    float total = 0;
    for (const float sum : sums) total += sum;
    return total;
}

/// Floating-point operations a second.
double measure(int threads) {
#if defined(__x86_64__)
    const bool fma = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    const bool fma = false;
#endif
    const auto start = std::chrono::steady_clock::now();
    float total = 0;
#pragma omp parallel num_threads(threads) reduction(+ : total)
    {
        const float seed = 1e-3F * static_cast<float>(omp_get_thread_num() + 1);
#if defined(__x86_64__)
        total += fma ? spin_fma(seed) : spin_plain(seed);
#else
        total += spin_plain(seed);
#endif
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    volatile float sink = total;  // so that the loops are not thrown away
    (void)sink;
    const double lanes = fma ? 8 : 1;
    return 2.0 * lanes * chains * static_cast<double>(turns) * threads / seconds.count();
}

}  // namespace

int main(int count, char** values) {
    const int threads = count > 1 ? std::atoi(values[1]) : omp_get_num_procs();
    double one = 0;
    double all = 0;
    for (int run = 0; run < 5; ++run) {  // the best: a peak
        const double a = measure(1);
        const double b = measure(threads);
        one = a > one ? a : one;
        all = b > all ? b : all;
    }
    std::printf("%.1f GFLOP/s with one thread, %.1f with %d\n", one / 1e9, all / 1e9, threads);
}
