// Every method against the exact attitude and against Eigen's own conversion: bench_methods OUT.csv

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <rotconv/conversion.hpp>
#include <rotconv/method.hpp>

#include "oracle.hpp"
#include "strata.hpp"

namespace {

using namespace rotconv;

constexpr std::size_t block = 256;
constexpr std::size_t million = 1'000'000;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN(); // an empty field

Spec parse(const std::string& text) { return std::get<Spec>(parse_spec(text)); }
std::string text_of(Name name) { return std::string(representation(name).text); }

// --- Eigen -----------------------------------------------------------------------------------------------------------

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using In = Eigen::Map<const Matrix>;
using Out = Eigen::Map<Matrix>;
using Vector = Eigen::Vector3d;
using Run = decltype(Method::run);

Eigen::Quaterniond quaternion(const double* q) { return {q[0], q[1], q[2], q[3]}; }
Vector vector(const double* v) { return {v[0], v[1], v[2]}; }
void store(const Vector& v, double* out) { Eigen::Map<Vector>{out} = v; }

template <std::size_t Inputs, std::size_t Outputs, class OneRow>
void each(const double* in, std::size_t rows, double* out, OneRow one_row) noexcept {
    for (std::size_t i = 0; i < rows; ++i, in += Inputs, out += Outputs) {
        one_row(in, out);
    }
}

void eigen_dcm_quat(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 4>(in, rows, out, [](const double* m, double* to) {
        const Eigen::Quaterniond q(In{m});
        to[0] = q.w();
        store(q.vec(), to + 1);
    });
}

void eigen_dcm_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        const Eigen::AngleAxisd a(In{m});
        store(a.angle() * a.axis(), to);
    });
}

void eigen_dcm_cayley(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<9, 3>(in, rows, out, [](const double* m, double* to) {
        const Eigen::Quaterniond q(In{m});
        store(q.vec() / q.w(), to);
    });
}

void eigen_quat_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 9>(in, rows, out, [](const double* q, double* to) { Out{to} = quaternion(q).toRotationMatrix(); });
}

void eigen_quat_rotvec(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<4, 3>(in, rows, out, [](const double* q, double* to) {
        const Eigen::AngleAxisd a(quaternion(q));
        store(a.angle() * a.axis(), to);
    });
}

void eigen_quat_euler(EulerSequence sequence, const double* in, std::size_t rows, double* out) noexcept {
    // constant axes, as in a program that knows its sequence
    if (sequence.proper()) {
        each<4, 3>(in, rows, out, [](const double* q, double* to) {
            store(quaternion(q).toRotationMatrix().eulerAngles(2, 0, 2), to);
        });
    } else {
        each<4, 3>(in, rows, out, [](const double* q, double* to) {
            store(quaternion(q).toRotationMatrix().eulerAngles(2, 1, 0), to);
        });
    }
}

void eigen_rotvec_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* v, double* to) {
        const Vector r = vector(v);
        const double angle = r.norm();
        Out{to} = Eigen::AngleAxisd(angle, r / angle).toRotationMatrix();
    });
}

void eigen_cayley_dcm(EulerSequence /*unused*/, const double* in, std::size_t rows, double* out) noexcept {
    each<3, 9>(in, rows, out, [](const double* c, double* to) {
        Out{to} = Eigen::Quaterniond(1.0, c[0], c[1], c[2]).normalized().toRotationMatrix();
    });
}

Run eigen_way(Name from, Name to) {
    static const std::map<std::pair<Name, Name>, Run> ways{
        {{Name::dcm, Name::quat}, eigen_dcm_quat},       {{Name::dcm, Name::rotvec}, eigen_dcm_rotvec},
        {{Name::dcm, Name::cayley}, eigen_dcm_cayley},   {{Name::quat, Name::dcm}, eigen_quat_dcm},
        {{Name::quat, Name::rotvec}, eigen_quat_rotvec}, {{Name::quat, Name::euler}, eigen_quat_euler},
        {{Name::rotvec, Name::dcm}, eigen_rotvec_dcm},   {{Name::cayley, Name::dcm}, eigen_cayley_dcm},
    };
    const auto found = ways.find({from, to});
    return found == ways.end() ? nullptr : found->second;
}

// --- Ways ------------------------------------------------------------------------------------------------------------

/// A method, rotconv's own way or Eigen's.
struct Way {
    std::string name;
    Run run; ///< null: rotconv's own

    void operator()(const Spec& from, const Spec& to, std::span<const double> in, std::size_t rows,
                    std::span<double> out) const {
        if (run != nullptr) {
            run(to.sequence, in.data(), rows, out.data());
            return;
        }
        const Conversion conversion(from, to,
                                    {.tolerance = infinity, .lock_margin = 0.0, .figures = false, .method = nullptr});
        std::array<Report, block> reports; // used again and again, as a stream does
        for (std::size_t first = 0; first < rows; first += block) {
            const std::size_t some = std::min(block, rows - first);
            conversion.run(in.subspan(first * from.size(), some * from.size()),
                           out.subspan(first * to.size(), some * to.size()), {reports.data(), some});
        }
    }
};

struct Pair {
    Name from;
    Name to;
    std::vector<Way> ways;
};

std::vector<Pair> pairs() {
    std::vector<Pair> found;
    for (const Method& method : methods()) {
        if (found.empty() || found.back().from != method.from || found.back().to != method.to) {
            found.push_back({method.from, method.to, {}});
            if (const Run run = eigen_way(method.from, method.to)) {
                found.back().ways.push_back({"Eigen", run});
            }
        }
        found.back().ways.push_back({std::string(method.name), method.run});
    }
    return found;
}

// --- Accuracy --------------------------------------------------------------------------------------------------------

/// Rows with the attitudes that they exactly stand for.
struct Sample {
    Spec from;
    Spec to;
    std::string stratum;
    bool hostile = false;
    double distance = none;
    bool relative = false;
    std::vector<std::vector<double>> rows;
    std::vector<oracle::Quaternion> exact;
};

/// What a method did to a sample, or to several.
struct Score {
    std::size_t rows = 0;
    std::size_t not_finite = 0;
    double worst = none; ///< eps; of the finite rows
    double squares = 0.0;
    double relative = none;
    double defect = none;
    std::string where; ///< the first row that is not finite, else the worst

    void add(const Score& other) {
        if ((other.not_finite > 0 && not_finite == 0) || (not_finite == 0 && !(other.worst <= worst))) {
            where = other.where.empty() ? where : other.where;
        }
        rows += other.rows;
        not_finite += other.not_finite;
        squares += other.squares;
        worst = std::fmax(worst, other.worst);
        relative = std::fmax(relative, other.relative);
        defect = std::fmax(defect, other.defect);
    }
    [[nodiscard]] double rms() const {
        return rows == not_finite ? none : std::sqrt(squares / static_cast<double>(rows - not_finite));
    }
};

std::string digits(std::span<const double> row) { return fmt::format("{:.17g}", fmt::join(row, " ")); }

/// The same attitude in other numbers or with noise.
void make_hostile(Name name, std::span<double> row, strata::Source& source) {
    const double scale =
        name == Name::rotvec ? std::pow(10.0, source.uniform(0, 14.4)) : std::pow(10.0, source.uniform(-150, 150));
    const double noise = name == Name::dcm ? std::pow(10.0, source.uniform(-17, -3.3)) : 0.0;
    for (double& v : row) {
        v = name == Name::dcm ? v + noise * source.uniform(-1, 1) : v * scale;
    }
}

void add_row(Sample& sample, std::vector<double> row) {
    if (std::ranges::all_of(row, [](double v) { return std::isfinite(v); })) {
        sample.exact.push_back(oracle::attitude(sample.from, row));
        sample.rows.push_back(std::move(row));
    }
}

/// The strata, then each of them made hostile.
std::vector<Sample> strata_of(const Spec& from, const Spec& to) {
    auto all = strata::attitudes(400);
    if (to.name == Name::euler) {
        all.push_back(strata::near_lock(to.sequence, 400));
    }
    strata::Source source(11);
    std::vector<Sample> samples;
    for (const bool hostile : {false, true}) {
        for (const auto& stratum : all) {
            Sample sample{from, to, stratum.name, hostile, none, stratum.name == "small angles", {}, {}};
            for (const auto& attitude : stratum.attitudes) {
                auto row = oracle::numbers(from, attitude);
                if (hostile) {
                    make_hostile(from.name, row, source);
                }
                add_row(sample, std::move(row));
            }
            samples.push_back(std::move(sample));
        }
    }
    return samples;
}

enum class Sweep { half_turn, identity, lock, noise };

Sample sweep_at(const Spec& from, const Spec& to, Sweep sweep, int exponent) {
    static constexpr std::array names{"to half-turn", "to identity", "to lock", "noise"};
    const double distance = std::pow(10.0, -exponent);
    Sample sample{
        from, to, names[static_cast<std::size_t>(sweep)], sweep == Sweep::noise, distance, sweep == Sweep::identity,
        {},   {}};
    strata::Source source(100 + static_cast<unsigned>(exponent));
    for (int i = 0; i < 60; ++i) {
        oracle::Quaternion q = source.attitude();
        const oracle::Vector3 axis = source.axis();
        if (sweep == Sweep::half_turn) {
            q = oracle::about(axis, oracle::pi() - distance);
        } else if (sweep == Sweep::identity) {
            q = oracle::about(axis, distance);
        } else if (sweep == Sweep::lock) {
            const oracle::Real middle = (oracle::pi() / 2 - distance) * (i % 2 == 0 ? 1 : -1);
            q = oracle::about(oracle::Vector3::UnitZ(), source.uniform(-3, 3)) *
                oracle::about(oracle::Vector3::UnitY(), middle) *
                oracle::about(oracle::Vector3::UnitX(), source.uniform(-3, 3));
        }
        auto row = oracle::numbers(from, q);
        if (sweep == Sweep::noise) {
            for (double& v : row) {
                v += distance * source.uniform(-1, 1);
            }
        }
        add_row(sample, std::move(row));
    }
    return sample;
}

std::vector<Sweep> sweeps_of(Name from, Name to) {
    if (from == Name::dcm && to == Name::quat) {
        return {Sweep::half_turn, Sweep::noise};
    }
    if (from == Name::dcm && to == Name::rotvec) {
        return {Sweep::half_turn, Sweep::identity};
    }
    if (from == Name::quat && to == Name::rotvec) {
        return {Sweep::identity};
    }
    return to == Name::euler ? std::vector{Sweep::lock} : std::vector<Sweep>{};
}

/// Error in eps of one result; nan where it is no attitude.
double error_of(const Sample& sample, std::size_t i, std::span<const double> result, double& relative) {
    const bool finite = std::ranges::all_of(result, [](double v) { return std::isfinite(v); });
    if (!finite) {
        // an infinite vector without nan says that this is a half-turn
        const bool half_turn =
            sample.to.name == Name::cayley && std::ranges::none_of(result, [](double v) { return std::isnan(v); });
        return half_turn ? static_cast<double>(2 * abs(sample.exact[i].w())) / oracle::eps : none;
    }
    const auto attitude = oracle::attitude(sample.to, result);
    if (sample.relative && sample.exact[i].vec().norm() > 0) {
        relative = std::fmax(relative, oracle::relative_error_in_eps(sample.exact[i], attitude));
    }
    return oracle::error_in_eps(sample.exact[i], attitude);
}

Score score(const Sample& sample, const Way& way) {
    Score made;
    made.rows = sample.rows.size();
    std::array<double, 9> numbers{};
    const std::span result(numbers.data(), sample.to.size());
    for (std::size_t i = 0; i < sample.rows.size(); ++i) {
        way(sample.from, sample.to, sample.rows[i], 1, result);
        const double error = error_of(sample, i, result, made.relative);
        if (std::isnan(error)) {
            if (++made.not_finite == 1) {
                made.where = digits(sample.rows[i]);
            }
            continue;
        }
        if (sample.to.name == Name::dcm) {
            made.defect = std::fmax(made.defect, static_cast<double>(oracle::defect(sample.to, result)) / oracle::eps);
        }
        made.squares += error * error;
        if (!(error <= made.worst)) {
            made.worst = error;
            made.where = made.not_finite > 0 ? made.where : digits(sample.rows[i]);
        }
    }
    return made;
}

// --- Time ------------------------------------------------------------------------------------------------------------

/// A million uniform attitudes.
std::vector<double> timed_rows(Name name, bool hostile) {
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    strata::Source source(8);
    const std::size_t size = representation(name).size;
    std::vector<double> rows(million * size);
    for (std::size_t i = 0; i < million; ++i) {
        const auto q = Eigen::Quaterniond(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
        double* const row = &rows[i * size];
        switch (name) {
        case Name::dcm: Out{row} = q.toRotationMatrix(); break;
        case Name::rotvec: {
            const Eigen::AngleAxisd a(q);
            store(a.angle() * a.axis(), row);
            break;
        }
        case Name::cayley: store(q.vec() / q.w(), row); break;
        default: row[0] = q.w(); store(q.vec(), row + 1);
        }
        if (hostile) {
            make_hostile(name, {row, size}, source);
        }
    }
    return rows;
}

/// The least time of each benchmark, nanoseconds a row.
class Least : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& /*context*/) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && run.iterations > 0) {
                const auto [place, first] = times_.try_emplace(run.run_name.function_name, infinity);
                const double rows = run.run_name.function_name.ends_with("/million") ? double(million) : double(block);
                place->second = std::min(place->second, run.GetAdjustedRealTime() / rows);
            }
        }
    }
    [[nodiscard]] double of(const std::string& name) const {
        const auto found = times_.find(name);
        return found == times_.end() ? none : found->second;
    }

private:
    std::map<std::string, double> times_;
};

std::string time_name(const Pair& pair, const std::string& way, bool hostile, bool all) {
    return fmt::format("{}-{}-{}-{}{}", text_of(pair.from), text_of(pair.to), way, hostile ? "hostile" : "clean",
                       all ? "/million" : "");
}

Spec target(Name to, const char* sequence = "ZYX") {
    return parse(to == Name::euler ? std::string("euler:") + sequence : text_of(to));
}

void measure(const std::vector<Pair>& pairs, Least& least) {
    std::vector<double> out(million * 9);
    for (const Name from : {Name::dcm, Name::quat, Name::rotvec, Name::cayley}) {
        benchmark::ClearRegisteredBenchmarks();
        std::deque<std::vector<double>> kept; // the benchmarks refer to them
        for (const bool hostile : {false, true}) {
            const auto& in = kept.emplace_back(timed_rows(from, hostile));
            for (const Pair& pair : pairs) {
                if (pair.from != from) {
                    continue;
                }
                for (const Way& way : pair.ways) {
                    for (const bool all : {false, true}) {
                        auto* const made =
                            benchmark::RegisterBenchmark(time_name(pair, way.name, hostile, all).c_str(),
                                                         [&in, &out, &way, all, source = parse(text_of(from)),
                                                          to = target(pair.to)](benchmark::State& state) {
                                                             for (auto _ : state) {
                                                                 way(source, to, in, all ? million : block, out);
                                                                 benchmark::ClobberMemory();
                                                             }
                                                         });
                        made->Unit(benchmark::kNanosecond)->Repetitions(all ? 3 : 7);
                        if (all) {
                            made->Iterations(1);
                        } else {
                            made->MinTime(0.01);
                        }
                    }
                }
            }
        }
        benchmark::RunSpecifiedBenchmarks(&least);
    }
}

// --- Output ----------------------------------------------------------------------------------------------------------

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.4g}", value); }

void write(std::ostream& csv, const Pair& pair, const Way& way, const std::string& stratum, bool hostile,
           double distance, const Score& s, const std::array<double, 4>& times = {none, none, none, none}) {
    csv << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", text_of(pair.from), text_of(pair.to),
                       way.name, stratum, hostile ? 1 : 0, field(distance), s.rows, s.not_finite, field(s.worst),
                       field(s.rms()), field(s.relative), field(s.defect), field(times[0]), field(times[1]),
                       field(times[2]), field(times[3]), s.where);
}

void write_pair(std::ostream& csv, const Pair& pair, const Least& least) {
    const Spec from = parse(text_of(pair.from));
    auto samples = strata_of(from, target(pair.to));
    if (pair.to == Name::euler) {
        auto more = strata_of(from, target(pair.to, "ZXZ"));
        for (std::size_t i = 0; i < more.size(); ++i) {
            samples.push_back(std::move(more[i]));
        }
    }
    std::vector<Sample> sweeps;
    for (const Sweep sweep : sweeps_of(pair.from, pair.to)) {
        for (int exponent = 1; exponent <= 16; ++exponent) {
            sweeps.push_back(sweep_at(from, target(pair.to), sweep, exponent));
        }
    }
    for (const Way& way : pair.ways) {
        std::array<Score, 2> totals;
        std::vector<std::pair<const Sample*, Score>> scores; // one a stratum, both sequences together
        for (const Sample& sample : samples) {
            const Score made = score(sample, way);
            totals[sample.hostile ? 1 : 0].add(made);
            const auto same = std::ranges::find_if(scores, [&](const auto& other) {
                return other.first->stratum == sample.stratum && other.first->hostile == sample.hostile;
            });
            if (same == scores.end()) {
                scores.emplace_back(&sample, made);
            } else {
                same->second.add(made);
            }
        }
        for (const auto& [sample, made] : scores) {
            write(csv, pair, way, sample->stratum, sample->hostile, none, made);
        }
        for (const Sample& sample : sweeps) {
            write(csv, pair, way, sample.stratum, sample.hostile, sample.distance, score(sample, way));
        }
        for (const bool hostile : {false, true}) {
            std::array<double, 4> times{};
            for (const bool all : {false, true}) {
                const double own = least.of(time_name(pair, way.name, hostile, all));
                times[all ? 1 : 0] = own;
                times[all ? 3 : 2] = own / least.of(time_name(pair, "Eigen", hostile, all));
            }
            write(csv, pair, way, hostile ? "hostile" : "clean", hostile, none, totals[hostile ? 1 : 0], times);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    std::string program = argv[0];
    std::string interleaving = "--benchmark_enable_random_interleaving=true";
    std::array<char*, 3> arguments{program.data(), interleaving.data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments.data());
    if (argc != 2) {
        std::fputs("usage: bench_methods OUT.csv\n", stderr);
        return 2;
    }
    std::ofstream csv(argv[1]);
    if (!csv) {
        std::perror(argv[1]);
        return 1;
    }
    const auto all = pairs();
    Least least;
    measure(all, least);
    csv << "from,to,method,stratum,hostile,distance,rows,not_finite,worst,rms,relative,defect,ns,ns_million,x_eigen,"
           "x_eigen_million,where\n";
    for (const Pair& pair : all) {
        write_pair(csv, pair, least);
    }
    csv.close();
    return csv ? 0 : 1;
}
