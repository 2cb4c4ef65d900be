#include "model/contact_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/real.hpp"

namespace zenosphere {
namespace {

/// Restitution of a viscoelastic collision from its equation of motion, in the unit of time in
/// which x'' = -x^(3/2) - A sqrt(x) x' for unit spheres, until the spheres part: x'' = 0.
/// Runge-Kutta.
///
/// \param stiffness  sqrt(reduced radius) / reduced mass, over that of unit spheres
double integrated_restitution(double constant, double stiffness = 1, double speed = 1) {
  const auto force = [&](double x, double v) {
    return x > 0 ? -stiffness * std::sqrt(x) * (x + constant * v) : 0;
  };
  const double h = 2e-4;
  double x = 0;
  double v = speed;
  for (;;) {
    const double a1 = force(x, v);
    const double v2 = v + h / 2 * a1;
    const double a2 = force(x + h / 2 * v, v2);
    const double v3 = v + h / 2 * a2;
    const double a3 = force(x + h / 2 * v2, v3);
    const double v4 = v + h * a3;
    const double a4 = force(x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (v < 0 && x + constant * v <= 0) return -v / speed;
  }
}

TEST(ViscoelasticRestitution, IsThatOfTheIntegratedCollision) {
  // The quotient agrees with the series up to x^5 = A^(5/2); beyond, Mueller & Poeschel find it
  // near the full solution. The differences below 1 are of the order A^3/20, beyond at most 0.008.
  for (const double a : {0.01, 0.05, 0.1, 0.2, 0.5}) {
    const double e = ViscoelasticRestitution<double>(a)(1);
    EXPECT_NEAR(e, integrated_restitution(a), 1e-6 + a * a * a / 15) << a;
  }
  for (const double a : {1.0, 2.0, 5.0}) {
    const double e = ViscoelasticRestitution<double>(a)(1);
    EXPECT_NEAR(e, integrated_restitution(a), 0.0085) << a;
  }
}

TEST(ViscoelasticRestitution, BeginsAsTheSeriesOfRamirez) {
  for (const double v : {1e-10, 1e-5, 1.0}) {
    const double ag = 1e-3 * std::pow(v, 0.2);
    const double series = 1 - 1.15344 * ag + 0.6 * 1.15344 * 1.15344 * ag * ag;
    // The next term is (4/15) ag^(5/2); 1.15344 is rounded in its sixth digit.
    EXPECT_NEAR(ViscoelasticRestitution<double>(1e-3)(v), series,
                0.3 * std::pow(ag, 2.5) + 1e-5 * ag)
        << v;
  }
}

TEST(ViscoelasticRestitution, OfUnequalSpheresIsThatOfTheIntegratedCollision) {
  struct Two {
    double diameters[2];
    double masses[2];
    double speed;
  };
  for (const auto& [diameters, masses, speed] :
       {Two{{1, 2}, {1, 8}, 0.5}, Two{{0.5, 3}, {0.125, 27}, 2}, Two{{1.4, 1.4}, {1, 1}, 1},
        Two{{2, 2}, {8, 8}, 1}, Two{{1, 1}, {1, 100}, 0.1}}) {
    const double reduced_radius = 1 / (2 / diameters[0] + 2 / diameters[1]);
    const double reduced_mass = 1 / (1 / masses[0] + 1 / masses[1]);
    const double stiffness = std::sqrt(reduced_radius) / reduced_mass;
    const double of_unit_spheres = std::sqrt(0.25) / 0.5;
    const double integrated = integrated_restitution(0.1, stiffness / of_unit_spheres, speed);
    const CollidingPair<double> pair{
        .inverse_masses = 1 / masses[0] + 1 / masses[1],
        .diameter = 2 * diameters[0] * diameters[1] / (diameters[0] + diameters[1])};
    // A (sqrt(R)/m)^(2/5) v^(1/5) is 0.3 at most: the quotient is good to a fifteenth of its cube.
    EXPECT_NEAR(ViscoelasticRestitution<double>(0.1)(speed, pair), integrated, 1e-4 + 0.027 / 15);
    EXPECT_GT(std::abs(ViscoelasticRestitution<double>(0.1)(speed) - integrated), 4e-3);
  }
}

TEST(ViscoelasticRestitution, DependsOnConstantAndSpeedThroughOneNumber) {
  // A v^(1/5): a speed 32 times as high is as good as twice the constant.
  EXPECT_DOUBLE_EQ(ViscoelasticRestitution<double>(0.2)(32 * 0.7),
                   ViscoelasticRestitution<double>(0.4)(0.7));
}

TEST(ViscoelasticRestitution, StaysBetweenOneAndZeroAndFallsWithTheSpeed) {
  const ViscoelasticRestitution<double> restitution(0.5);
  double last = 1;
  for (double v = 1e-300; v < 1e300; v *= 1e3) {
    const double e = restitution(v);
    EXPECT_GT(e, 0) << v;
    EXPECT_LE(e, last) << v;
    last = e;
  }
}

TEST(ViscoelasticRestitution, IsTheSameNumberInEveryPrecision) {
  const double e = ViscoelasticRestitution<double>(0.25)(0.5);
  EXPECT_NEAR(static_cast<double>(ViscoelasticRestitution<Extended>(0.25)(0.5)), e, 1e-15);
  EXPECT_NEAR(static_cast<double>(ViscoelasticRestitution<Quad>(0.25)(0.5)), e, 1e-15);
  EXPECT_NEAR(static_cast<double>(ViscoelasticRestitution<Digits>(0.25)(0.5)), e, 1e-15);
}

/// Energy that a collision of two unit masses takes at the speed 2 sqrt(loss) (1 + above), over the
/// loss, less 1.
template <class Real>
double excess_of_the_loss(const Real& loss, const Real& above) {
  using std::sqrt;
  const Real v = Real(2 * sqrt(loss)) * (1 + above);
  const Real e = FixedLossRestitution<Real>(loss)(v);
  return static_cast<double>(Real((1 - e * e) * v * v / 4 / loss - 1));
}

/// \param rounding  of the type; (1 - e^2) v^2 amplifies it by v^2/c^2 for e near 1
template <class Real>
void expect_the_loss_itself(double rounding) {
  for (const double loss : {1e-12, 0.25, 0.3, 7e9}) {
    for (const double above : {1e-9, 1e-3, 0.5, 9.0}) {
      EXPECT_NEAR(excess_of_the_loss(Real(loss), Real(above)), 0,
                  8 * rounding * (1 + above) * (1 + above))
          << loss << ' ' << above;
    }
  }
}

TEST(FixedLossRestitution, TakesTheSameEnergyOfEveryEnergeticCollisionInEveryPrecision) {
  expect_the_loss_itself<double>(0x1p-52);
  expect_the_loss_itself<Extended>(0x1p-63);
  expect_the_loss_itself<Quad>(0x1p-112);
  expect_the_loss_itself<Digits>(1e-100);
}

TEST(FixedLossRestitution, IsOneUpToTheThresholdItselfAndAboveItBeginsFromZero) {
  const FixedLossRestitution<double> restitution(0.25);  // threshold 1
  EXPECT_EQ(restitution(1e-300), 1);
  EXPECT_EQ(restitution(0.999), 1);
  EXPECT_EQ(restitution(1), 1);
  // v = 1 + 2^-52: e^2 = (v - 1)(v + 1)/v^2 = 2^-51 (1 - 3/2 x 2^-52 ...).
  EXPECT_NEAR(restitution(std::nextafter(1.0, 2.0)), std::sqrt(0x1p-51), 4e-16 * 0x1p-25);
}

TEST(FixedLossRestitution, TendsToOneAtHighSpeeds) {
  const FixedLossRestitution<double> restitution(0.25);
  EXPECT_DOUBLE_EQ(restitution(1e4), 1 - 0.5e-8);  // 1 - 2 loss/v^2; the next term is 1e-17
  EXPECT_EQ(restitution(1e200), 1);                // its square is no number
  EXPECT_EQ(FixedLossRestitution<double>(1e300)(1e160), 1);
}

TEST(FixedLossRestitution, IsTheSameNumberInEveryPrecision) {
  const double e = FixedLossRestitution<double>(0.0625)(0.8);  // sqrt(1 - 0.25/0.64)
  EXPECT_DOUBLE_EQ(e, std::sqrt(0.609375));
  EXPECT_NEAR(static_cast<double>(FixedLossRestitution<Extended>(0.0625)(0.8)), e, 2e-16);
  EXPECT_NEAR(static_cast<double>(FixedLossRestitution<Quad>(0.0625)(0.8)), e, 2e-16);
  EXPECT_NEAR(static_cast<double>(FixedLossRestitution<Digits>(0.0625)(0.8)), e, 2e-16);
}

TEST(TwoValuedRestitution, ChangesAtTheThresholdItself) {
  const TwoValuedRestitution<double> restitution{0.8, 0.95, 0.5};
  EXPECT_EQ(restitution(1e-300), 0.8);
  EXPECT_EQ(restitution(std::nextafter(0.5, 0.0)), 0.8);
  EXPECT_EQ(restitution(0.5), 0.95);
  EXPECT_EQ(restitution(1e200), 0.95);
  EXPECT_EQ(TwoValuedRestitution<Digits>({Digits("0.8"), Digits(1), Digits(2)})(Digits(1)),
            Digits("0.8"));
}

TEST(RestitutionLaws, AreMadeOfTheNumbersOfACaseInThePrecisionOfTheRun) {
  RestitutionLaws::Numbers numbers;
  numbers.viscoelastic_constant = 0.3;
  numbers.energy_loss = 0.1;
  numbers.slow_restitution = 0.7;
  numbers.fast_restitution = 0.9;
  numbers.threshold_speed = 2;
  const auto at_speed_one = [&]<class Law>(const Law*, RestitutionLaw choice) {
    const auto law = RestitutionLaws::chosen<Quad>(choice, numbers);
    return std::get<Law>(law.value())(Quad(1));
  };
  using Soft = ViscoelasticRestitution<Quad>;
  EXPECT_EQ(at_speed_one(static_cast<Soft*>(nullptr), RestitutionLaw::viscoelastic),
            Soft(Quad("0.3"))(Quad(1)));
  using Losing = FixedLossRestitution<Quad>;
  EXPECT_EQ(at_speed_one(static_cast<Losing*>(nullptr), RestitutionLaw::fixed_loss),
            Losing(Quad("0.1"))(Quad(1)));
  using Two = TwoValuedRestitution<Quad>;
  EXPECT_EQ(at_speed_one(static_cast<Two*>(nullptr), RestitutionLaw::two_valued), Quad("0.7"));
  EXPECT_FALSE(RestitutionLaws::chosen<Quad>(RestitutionLaw::constant, numbers));
}

TEST(ContactModels, AreOffUnlessOneIsChosen) {
  EXPECT_FALSE(ContactModels<double>{}.is_any());
  EXPECT_TRUE((ContactModels<double>{.law = ViscoelasticRestitution<double>(1)}).is_any());
  EXPECT_TRUE((ContactModels<double>{.contact_duration = 1e-9}).is_any());
  EXPECT_TRUE((ContactModels<double>{.rotation_angle = 1e-9}).is_any());
}

}  // namespace
}  // namespace zenosphere
