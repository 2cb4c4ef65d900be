#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

TEST(CaseContact, ModelsAreOffByDefault) {
  const Case values = parse_case(cooling_case, "e.toml", {});
  EXPECT_EQ(values.collision.restitution_law, RestitutionLaw::constant);
  EXPECT_EQ(values.collision.contact_duration, 0);
  EXPECT_EQ(values.collision.rotation_angle, 0);
}

TEST(CaseContact, ViscoelasticSpheresHaveAConstantInsteadOfARestitution) {
  const std::string viscoelastic =
      cooling_case + "[collision]\nrestitution_law = \"viscoelastic\"\n";
  EXPECT_EQ(problems_of(viscoelastic + "viscoelastic_constant = 0.1\n"),
            "e.toml:5:15: system.restitution = 0.9 (only for collision.restitution_law = "
            "\"constant\"); remove it");
  // What an override takes the meaning from may stay.
  EXPECT_EQ(objection(cooling_case + "[collision]\nviscoelastic_constant = 0.1\n",
                      "collision.restitution_law=viscoelastic"),
            "");
  EXPECT_EQ(objection(cooling_case, "collision.restitution_law=viscoelastic"),
            "e.toml: missing key collision.viscoelastic_constant (physics has no default); add "
            "viscoelastic_constant = ... under [collision]");
  EXPECT_EQ(objection(cooling_case, "collision.viscoelastic_constant=0.1"),
            "collision.viscoelastic_constant = 0.1 (only for collision.restitution_law = "
            "\"viscoelastic\"); remove it");
}

TEST(CaseContact, AFixedLossIsAnEnergyInsteadOfARestitution) {
  const std::string fixed = cooling_case + "[collision]\nrestitution_law = \"fixed-loss\"\n";
  EXPECT_EQ(problems_of(fixed + "energy_loss = 0.1\n"),
            "e.toml:5:15: system.restitution = 0.9 (only for collision.restitution_law = "
            "\"constant\"); remove it");
  EXPECT_EQ(objection(cooling_case, "collision.restitution_law=fixed-loss"),
            "e.toml: missing key collision.energy_loss (physics has no default); add "
            "energy_loss = ... under [collision]");
  EXPECT_EQ(objection(cooling_case, "collision.energy_loss=0.1"),
            "collision.energy_loss = 0.1 (only for collision.restitution_law = "
            "\"fixed-loss\"); remove it");
  const std::string given = cooling_case + "[collision]\nenergy_loss = 0.1\n";
  const Case values =
      parse_case(given, "e.toml", std::vector<std::string>{"collision.restitution_law=fixed-loss"});
  EXPECT_EQ(values.collision.restitution_law, RestitutionLaw::fixed_loss);
  EXPECT_EQ(values.collision.energy_loss, 0.1);
  const std::string none = cooling_case + "[collision]\nenergy_loss = 0\n";
  EXPECT_NE(objection(none, "collision.restitution_law=fixed-loss").find("must be in (0, 1e+300]"),
            std::string::npos);
}

TEST(CaseContact, TwoValuesTakeTheTwoAndTheSpeedBetweenThem) {
  const std::string of_two = cooling_case + "[collision]\nrestitution_law = \"two-valued\"\n";
  EXPECT_EQ(problems_of(of_two + "slow_restitution = 0.8\nfast_restitution = 0.95\n"
                                 "threshold_speed = 1\n"),
            "e.toml:5:15: system.restitution = 0.9 (only for collision.restitution_law = "
            "\"constant\"); remove it");
  EXPECT_EQ(objection(cooling_case, "collision.threshold_speed=1"),
            "collision.threshold_speed = 1 (only for collision.restitution_law = "
            "\"two-valued\"); remove it");
  const std::string half = cooling_case + "[collision]\nslow_restitution = 0.8\n";
  const std::string missing = objection(half, "collision.restitution_law=two-valued");
  EXPECT_NE(missing.find("missing key collision.fast_restitution"), std::string::npos) << missing;
}

TEST(CaseContact, WordsAndNumbersAreChecked) {
  EXPECT_EQ(objection(cooling_case, "collision.restitution_law=viscous"),
            "collision.restitution_law = \"viscous\" (must be \"constant\", "
            "\"viscoelastic\", \"fixed-loss\" or \"two-valued\")");
  EXPECT_EQ(objection(cooling_case, "collision.contact_duration=-1"),
            "collision.contact_duration = -1 (must be in [0, 1e+100]; 0 is off)");
  EXPECT_EQ(objection(cooling_case, "collision.rotation_angle=2"),
            "collision.rotation_angle = 2 (must be in [0, 1.57]; 0 is off)");
}

TEST(CaseContact, NothingRotatesOnALine) {
  EXPECT_EQ(
      objection(rod_case, "collision.rotation_angle=0.1"),
      "collision.rotation_angle = 0.1 (nothing turns on a line, system.dimension = 1); remove "
      "it or use 2 or 3 dimensions");
  EXPECT_EQ(objection(rod_case, "collision.rotation_angle=0"), "");
}

}  // namespace
}  // namespace zenosphere
