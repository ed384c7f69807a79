#pragma once

namespace rotconv {

// NOLINTBEGIN(bugprone-exception-escape): where there is no memory for a number, the program ends
/// A number and a bound on its error, of as many bits as the thread works with (Wide::Bits), with an exponent of any
/// size: for the few rows that 106 bits do not decide. Every operation adds to the bound what it rounds, so that no
/// formula over it needs an analysis. It is compiled once for all processors, and shows them nothing of the library
/// that it is made with.
class Wide {
public:
    struct Number;

    /// How the thread works, as long as this lives.
    class Bits {
    public:
        explicit Bits(int bits) noexcept;
        ~Bits();
        Bits(const Bits&) = delete;
        Bits& operator=(const Bits&) = delete;
        /// Whether the bits did not tell a sign that was asked for.
        [[nodiscard]] static bool doubted() noexcept;
        static int bits() noexcept;
        static void doubt() noexcept;

    private:
        int bits_before_;
        bool doubted_before_;
    };

    /// For numbers of which several doubles are left.
    static constexpr int bits_of_rest = 640;

    Wide() noexcept : Wide(0.0) {}
    Wide(double value) noexcept;
    Wide(double high, double low) noexcept;
    // NOLINTNEXTLINE(*-member-init): it delegates
    template <class Parts, class = decltype(Parts::lo)> Wide(const Parts& parts) noexcept : Wide(parts.hi, parts.lo) {}
    Wide(const Wide& other) noexcept;
    Wide(Wide&& other) noexcept : number_(other.number_) { other.number_ = nullptr; }
    Wide& operator=(const Wide& other) noexcept { return *this = Wide(other); }
    Wide& operator=(Wide&& other) noexcept {
        Number* const own = number_;
        number_ = other.number_;
        other.number_ = own;
        return *this;
    }
    ~Wide();

    /// The nearest double; false where the bound leaves two: then, if it leaves 0, this, or else, if it leaves the
    /// middle between two neighbours, the even one.
    [[nodiscard]] bool round(double& nearest) const noexcept;
    [[nodiscard]] double rounded() const noexcept;
    /// Whether it may be 0, but need not.
    [[nodiscard]] bool may_be_zero() const noexcept;
    [[nodiscard]] bool is_below(int exponent) const noexcept; ///< in size, than 2^exponent
    /// The number itself, without its bound.
    [[nodiscard]] Wide middle() const noexcept;
    /// Adds the size of `error`, and its own bound, to the bound.
    void widen(const Wide& error) noexcept;
    /// -1, 0 or 1; 0, and a doubt, where it may be 0 but need not.
    [[nodiscard]] int sign() const noexcept;
    /// That of the leading bit; very low for 0.
    [[nodiscard]] int exponent() const noexcept;
    [[nodiscard]] Wide shifted(int power) const noexcept; ///< times 2^power

    static Wide half_turn(bool in_degrees) noexcept;
    static void sine_cosine(const Wide& angle, bool in_degrees, Wide& sine, Wide& cosine) noexcept;
    /// In [-pi, pi]; 0 of (0, 0).
    static Wide angle_of(const Wide& x, const Wide& y, bool in_degrees) noexcept;

    friend Wide operator-(const Wide& a) noexcept;
    friend Wide operator+(const Wide& a, const Wide& b) noexcept;
    friend Wide operator-(const Wide& a, const Wide& b) noexcept;
    friend Wide operator*(const Wide& a, const Wide& b) noexcept;
    friend Wide operator/(const Wide& a, const Wide& b) noexcept; ///< not finite where b may be 0
    friend Wide root(const Wide& a) noexcept;
    friend Wide scaled(const Wide& a, double power) noexcept;
    friend Wide clean_difference(const Wide& a, const Wide& b) noexcept { return a - b; }
    friend Wide select(bool condition, const Wide& yes, const Wide& no) noexcept { return condition ? yes : no; }
    friend bool is_at_most(const Wide& a, const Wide& b) noexcept { return (b - a).sign() >= 0; }
    friend double to_double(const Wide& a) noexcept { return a.rounded(); }
    friend double sign_of(const Wide& a) noexcept { return a.sign(); }

private:
    explicit Wide(Number* number) noexcept : number_(number) {}
    static void find_sine_cosine(const Wide& angle, bool in_degrees, Wide& sine, Wide& cosine) noexcept;
    static void series_of(const Wide& rest, Wide& sine, Wide& cosine) noexcept;
    static Wide acute_angle(const Wide& near, const Wide& far) noexcept;

    Number* number_;
};

// NOLINTEND(bugprone-exception-escape)
} // namespace rotconv
