// SPDX-License-Identifier: Apache-2.0
// Lets loops that work on many numbers use registers of eight numbers where the processor has them;
// programs run on all others, too. Results are the same to the last bit: multiplications and
// additions are not fused.
#pragma once

/// Stands before a function, no template, with such loops; what it calls must be inlined. Which of
/// the function's two versions is called is decided while the program starts, before sanitizers are
/// ready: they get one.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SLINE_WIDE_LOOPS __attribute__((target_clones("avx2", "default")))
#else
#define SLINE_WIDE_LOOPS
#endif

/// Stands before a loop whose rounds neither read nor write memory that another round writes; they
/// may add to variables of the function. Compilers find that out by themselves for a few rows of
/// numbers, not for many.
#if defined(__clang__)
#define SLINE_INDEPENDENT_ROUNDS _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define SLINE_INDEPENDENT_ROUNDS _Pragma("GCC ivdep")
#else
#define SLINE_INDEPENDENT_ROUNDS
#endif
