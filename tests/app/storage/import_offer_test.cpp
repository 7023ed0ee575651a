// What the dialog before an import takes as choices, and what they mean.
#include "app/storage/import_offer.h"

#include <limits>

#include "messages.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

using namespace interleaf;

namespace {

const ImportDialogShown offer_of_two{.title = "Import a.pvd",
                                     .detail = "2 steps",
                                     .fields = {"u", "p"},
                                     .scalars = {"u x", "u y", "p"},
                                     .vectors = {"u"},
                                     .fault = ""};

ImportDialogChoices choices_with(auto change) {
    ImportDialogChoices choices = dialog_choices({}, offer_of_two);
    change(choices);
    return choices;
}

std::string fault_with(auto change) {
    return fault_of(choices_with(change), offer_of_two);
}

}  // namespace

TEST_CASE("the usual choices have no fault and mean the defaults") {
    const ImportDialogChoices usual = dialog_choices({}, offer_of_two);
    CHECK(fault_of(usual, offer_of_two).empty());
    const ImportChoices wanted = import_choices(usual, offer_of_two);
    CHECK(wanted.every == 1);
    CHECK_FALSE(wanted.tolerance);
    CHECK_FALSE(wanted.newest);
    CHECK(wanted.fields.empty());
    CHECK(wanted.displacement.empty());
    CHECK_FALSE(wanted.warp);
    CHECK(wanted.roots.empty());
}

TEST_CASE("choices with a fault name the row") {
    using Choices = ImportDialogChoices;
    for (const char* const every : {"", "0", "-1", "1.5", "x", "4294967295"}) {
        CAPTURE(every);
        CHECK(contains(fault_with([&](Choices& c) { c.every = every; }), "Every: "));
    }
    for (const char* const tolerance : {"-1", "101", "nan", "x"}) {
        CAPTURE(tolerance);
        CHECK(contains(fault_with([&](Choices& c) { c.tolerance = tolerance; }), "Tolerance: "));
    }
    const ScratchFolder folder;
    CHECK(contains(fault_with([&](Choices& c) { c.roots = (folder / "no.ilh").string(); }), "Roots: "));
    CHECK(contains(fault_with([&](Choices& c) { c.roots = folder.path().string(); }), "Roots: "));
    put(folder / "a.ilh", "");
    CHECK(fault_with([&](Choices& c) { c.roots = (folder / "a.ilh").string(); }).empty());
    for (const double factor : {std::numeric_limits<double>::quiet_NaN(), 1e39})
        CHECK(contains(fault_with([&](Choices& c) { c.factor = factor; }), "Warp: "));
    CHECK(contains(fault_with([](Choices& c) { c.are_wanted = {false, false}; }), "Fields: "));
    CHECK(fault_of(dialog_choices({}, {}), {}).empty());
}

TEST_CASE("choices become those of the import: percent as parts, corners from 0, fields by name") {
    const ImportDialogChoices choices = choices_with([](ImportDialogChoices& c) {
        c.every = "3";
        c.tolerance = "2.5";
        c.newest = 3;
        c.warp = "p";
        c.factor = -2;
        c.displacement = "u";
        c.are_wanted = {false, true};
    });
    CHECK(fault_of(choices, offer_of_two).empty());
    const ImportChoices wanted = import_choices(choices, offer_of_two);
    CHECK(wanted.every == 3);
    CHECK(wanted.tolerance == 0.025);
    CHECK(wanted.newest == 2U);
    REQUIRE(wanted.warp);
    CHECK(wanted.warp->field == "p");
    CHECK(wanted.warp->factor == -2);
    CHECK(wanted.displacement == "u");
    CHECK(wanted.fields == std::vector<std::string>{"p"});
}

TEST_CASE("the dialog keeps every digit of a typed tolerance, and shows no more than it needs") {
    for (const char* const text : {"7", "33.333333333333336", "0.123456789", "12.3456789012345", "1e-05"}) {
        CAPTURE(text);
        const ImportChoices typed =
            import_choices(choices_with([&](ImportDialogChoices& c) { c.tolerance = text; }), offer_of_two);
        CHECK(import_choices(dialog_choices(typed, offer_of_two), offer_of_two).tolerance == typed.tolerance);
    }
    CHECK(dialog_choices({.tolerance = 0.07}, offer_of_two).tolerance == "7");
}

TEST_CASE("the dialog shows the choices of the last import again, as far as the series has their fields") {
    const ImportChoices last{.tolerance = 0.025,
                             .newest = 2U,
                             .fields = {"p"},
                             .displacement = "u",
                             .warp = ChosenWarp{"p", -2},
                             .every = 3,
                             .roots = "/a/roots.ilh"};
    CHECK(import_choices(dialog_choices(last, offer_of_two), offer_of_two) == last);
    const ImportDialogChoices without =
        dialog_choices({.fields = {"q"}, .displacement = "v", .warp = ChosenWarp{"q", 1}}, offer_of_two);
    CHECK(import_choices(without, offer_of_two) == ImportChoices{});
}
