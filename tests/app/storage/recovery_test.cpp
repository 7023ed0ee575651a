// Tests of recovery: that nothing is lost, nothing is taken twice, and nothing is taken from the living.
#include "app/storage/recovery.h"

#include <csignal>
#include <memory>
#include <tuple>

#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/sample_family.h"
#include "app/storage/autosave_writer.h"
#include "app/storage/document_recovery.h"
#include "app/storage/running_process.h"
#include "io/family/family_file.h"
#include "io/samples.h"

using namespace interleaf;

namespace fs = std::filesystem;

namespace {

std::shared_ptr<const Family> family_called(const std::string& name, unsigned seed = 1) {
    std::mt19937 random(seed);
    auto family = std::make_shared<Family>();
    family->name = name;
    family->keys.push_back({"a", random_hierarchy(random, false, 3)});
    family->keys.push_back({"b", random_hierarchy(random, false, 5)});
    return family;
}

/// Another program that has autosaved a family and goes on running.
class OtherProgram {
  public:
    OtherProgram(const fs::path& state, const std::string& name) {
        int ends[2];
        REQUIRE(::pipe(ends) == 0);
        process_ = ::fork();
        REQUIRE(process_ >= 0);
        if (process_ == 0) {
            AutosaveWriter writer(state);
            writer.write(family_called(name), "/documents/" + name);
            writer.finish();
            if (::write(ends[1], "!", 1) != 1) ::_exit(1);
            for (;;) ::pause();
        }
        char ready = 0;
        REQUIRE(::read(ends[0], &ready, 1) == 1);
        ::close(ends[0]);
        ::close(ends[1]);
    }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;
    ~OtherProgram() { kill(); }

    /// Ends the program as a crash would. Its number stays in use until wait().
    void crash() const { ::kill(process_, SIGKILL); }
    void kill() {
        if (process_ == 0) return;
        crash();
        ::waitpid(process_, nullptr, 0);
        process_ = 0;
    }
    pid_t number() const { return process_; }

  private:
    pid_t process_ = 0;
};

std::size_t folders_in(const fs::path& folder) {
    if (!fs::exists(folder)) return 0;
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A recovery of a program that has ended, named \p name.
void put_abandoned(const fs::path& state, const std::string& folder, const std::string& name,
                   std::int64_t time) {
    const fs::path path = state / "recovery" / folder;
    write_family(*family_called(name), path / "family");
    put(path / "recovery.json", recovery_note_text({.name = name, .document_folder = {}, .time = time}));
}

/// A number that no process has: the kernel's largest is 2^22.
constexpr const char* nobody = "4194305-1";

}  // namespace

TEST_CASE("a program that is killed leaves its document to the next one, not before") {
    const ScratchFolder state;
    OtherProgram other(state.path(), "Five keys");
    CHECK(abandoned_recoveries(state.path()).empty());
    other.kill();

    const auto found = abandoned_recoveries(state.path());
    REQUIRE(found.size() == 1);
    CHECK(found[0].note.name == "Five keys");
    CHECK(found[0].note.document_folder == "/documents/Five keys");
    CHECK(found[0].note.time > 1'700'000'000);
    const Family family = read_family(found[0].family());
    CHECK(family.name == "Five keys");
    CHECK(is_same(*family.keys.at(1).hierarchy, *family_called("")->keys[1].hierarchy));
}

TEST_CASE("a dead process that nobody has waited for counts as dead") {
    const ScratchFolder state;
    OtherProgram other(state.path(), "x");
    other.crash();
    siginfo_t info{};
    REQUIRE(::waitid(P_PID, static_cast<id_t>(other.number()), &info, WEXITED | WNOWAIT) == 0);
    CHECK(abandoned_recoveries(state.path()).size() == 1);
}

TEST_CASE("a process that has got the number of another is told apart from it") {
    const ScratchFolder state;
    const ProcessIdentity self = this_process();
    put_abandoned(state.path(), fmt::format("{}-{}", self.number, self.start_time), "mine", 1);
    put_abandoned(state.path(), fmt::format("{}-{}-2", self.number, self.start_time), "mine, too", 2);
    CHECK(abandoned_recoveries(state.path()).empty());
    put_abandoned(state.path(), fmt::format("{}-{}", self.number, self.start_time - 1), "another's", 3);
    const auto found = abandoned_recoveries(state.path());
    REQUIRE(found.size() == 1);
    CHECK(found[0].note.name == "another's");
}

TEST_CASE("the latest recovery comes first") {
    const ScratchFolder state;
    put_abandoned(state.path(), "4194305-1", "first", 1);
    put_abandoned(state.path(), "4194305-2", "third", 3);
    put_abandoned(state.path(), "4194305-3-claimed-1", "second", 2);
    std::string names;
    for (const Recovery& recovery : abandoned_recoveries(state.path())) names += recovery.note.name + " ";
    CHECK(names == "third second first ");
}

TEST_CASE("of many programs that claim a recovery one gets it, and it is no longer abandoned") {
    const ScratchFolder state;
    put_abandoned(state.path(), nobody, "wanted", 1);
    const auto found = abandoned_recoveries(state.path());
    REQUIRE(found.size() == 1);
    constexpr int programs = 8;
    std::vector<pid_t> processes;
    for (int i = 0; i < programs; ++i) {
        const pid_t process = ::fork();
        if (process == 0) {
            const bool has_it = claim_recovery(found[0]).has_value();
            ::_exit(has_it ? 1 : 0);
        }
        processes.push_back(process);
    }
    int winners = 0;
    for (const pid_t process : processes) {
        int status = 0;
        ::waitpid(process, &status, 0);
        winners += WEXITSTATUS(status);
    }
    CHECK(winners == 1);

    // The winner has ended without discarding it: nothing is lost.
    const auto again = abandoned_recoveries(state.path());
    REQUIRE(again.size() == 1);
    const auto claimed = claim_recovery(again[0]);
    REQUIRE(claimed);
    CHECK_FALSE(claim_recovery(again[0]));
    CHECK(abandoned_recoveries(state.path()).empty());
    CHECK(read_family(claimed->family()).name == "wanted");
    CHECK(claimed->note.name == "wanted");

    discard_recovery(*claimed);
    CHECK(folders_in(state / "recovery") == 0);
    discard_recovery(*claimed);
}

TEST_CASE("one program can claim several recoveries beside its own autosave") {
    const ScratchFolder state;
    AutosaveWriter writer(state.path());
    writer.write(family_called("own"), {});
    writer.finish();
    put_abandoned(state.path(), "4194305-1", "one", 1);
    put_abandoned(state.path(), "4194305-2", "two", 2);
    for (const Recovery& recovery : abandoned_recoveries(state.path())) CHECK(claim_recovery(recovery));
    CHECK(folders_in(state / "recovery") == 3);
    CHECK(abandoned_recoveries(state.path()).empty());
}

TEST_CASE("leftovers without a family are removed, what is not ours is left alone") {
    const ScratchFolder state;
    fs::create_directories(state / "recovery/4194305-7/family");
    put(state / "recovery/4194305-7/family/a.ilh", "half");
    for (const char* name : {"notes", "12x-1", "-1-1", "0-1", "4194305", "4194305-", "4194305-1x"})
        fs::create_directory(state / "recovery" / name);
    put(state / "recovery/4194305-9", "a file");
    CHECK(abandoned_recoveries(state.path()).empty());
    CHECK_FALSE(fs::exists(state / "recovery/4194305-7"));
    CHECK(folders_in(state / "recovery") == 8);
}

TEST_CASE("a damaged note does not lose the family") {
    for (const char* text :
         {"", "{", R"({"name": "a\nb", "time": 0})", R"({"name": "x", "time": -1})",
          R"({"name": "x", "time": 1e300})", R"({"name": "x", "time": 0, "folder": "a"})"}) {
        CAPTURE(text);
        const ScratchFolder state;
        put_abandoned(state.path(), nobody, "x", 1);
        put(state.path() / "recovery" / nobody / "recovery.json", text);
        CHECK_FALSE(input_error_of([&] { parse_recovery_note(text, "NOTE"); }).empty());
        const auto found = abandoned_recoveries(state.path());
        REQUIRE(found.size() == 1);
        CHECK(found[0].note.name == "Unnamed");
        CHECK(read_family(found[0].family()).name == "x");
    }
}

TEST_CASE("a note that is written comes back") {
    for (const RecoveryNote& note :
         {RecoveryNote{.name = "Fünf \"Keys\"", .document_folder = "/a/b c", .time = 1'800'000'000},
          RecoveryNote{.name = "", .document_folder = {}, .time = 0}})
        CHECK(parse_recovery_note(recovery_note_text(note), "NOTE") == note);
    const RecoveryNote odd{.name = "\xff", .document_folder = "/\xff", .time = 1};
    CHECK(parse_recovery_note(recovery_note_text(odd), "NOTE") ==
          RecoveryNote{.name = "Unnamed", .document_folder = {}, .time = 1});
}

TEST_CASE("the newest of many snapshots is what is kept, and clearing removes it") {
    const ScratchFolder state;
    AutosaveWriter writer(state.path());
    writer.finish();
    CHECK(folders_in(state / "recovery") == 0);
    std::shared_ptr<const Family> last;
    for (unsigned i = 0; i < 200; ++i) {
        last = family_called(fmt::format("version {}", i), i % 3);
        writer.write(last, {});
    }
    writer.finish();
    REQUIRE(folders_in(state / "recovery") == 1);
    const Recovery own{.folder = fs::directory_iterator(state / "recovery")->path(), .note = {}};
    const Family family = read_family(own.family());
    CHECK(family.name == "version 199");
    CHECK(is_same(*family.keys.at(0).hierarchy, *last->keys[0].hierarchy));
    CHECK(last.use_count() == 1);

    writer.write(last, {});
    writer.clear();
    writer.finish();
    CHECK(folders_in(state / "recovery") == 0);
    CHECK_FALSE(writer.take_error());
}

TEST_CASE("what was asked for last is done before the writer ends") {
    const ScratchFolder state;
    { AutosaveWriter(state.path()).write(family_called("last"), {}); }
    CHECK(folders_in(state / "recovery") == 1);
    {
        AutosaveWriter writer(state.path());
        writer.write(family_called("more"), {});
        writer.clear();
    }
    CHECK(folders_in(state / "recovery") == 1);
}

TEST_CASE("an error is reported once, and again only after a success") {
    const ScratchFolder state;
    AutosaveWriter writer(state.path());
    const auto write = [&] {
        writer.write(family_called("x"), {});
        writer.finish();
        return writer.take_error();
    };
    put(state / "recovery", "in the way");
    const auto error = write();
    REQUIRE(error);
    CHECK(error->starts_with((state / "recovery").string()));
    CHECK_FALSE(write());
    fs::remove(state / "recovery");
    CHECK_FALSE(write());
    fs::remove_all(state / "recovery");
    put(state / "recovery", "in the way");
    CHECK(write());
    CHECK_FALSE(write());
}

TEST_CASE(
    "what was recovered is autosaved where it was, so that it is kept once, and goes once it is saved") {
    for (const bool is_saved : {false, true}) {
        CAPTURE(is_saved);
        const ScratchFolder state;
        put_abandoned(state.path(), nobody, "lost", 1);
        {
            Document document(*family_called("begun"));
            DocumentRecovery recovery(state.path(), document);
            REQUIRE(recovery.offered() != nullptr);
            CHECK(recovery.offered()->note.name == "lost");
            auto claimed = recovery.claim_offered();
            REQUIRE(claimed);
            CHECK(recovery.offered() == nullptr);
            recovery.forget(document);
            document = Document(read_family(claimed->family()));
            document.mark_unsaved();
            recovery.adopt(*std::move(claimed));
            CHECK(folders_in(state / "recovery") == 1);

            document.edit("Rename", *family_called("found"));
            recovery.look_after(document, false, 10);
            recovery.look_after(document, false, 20);
            if (is_saved) {
                document.mark_saved(document.snapshot(), "/documents/found");
                recovery.forget(document);
            }
        }  // ends as the program does
        CHECK(folders_in(state / "recovery") == (is_saved ? 0 : 1));
        if (is_saved) continue;
        const Recovery left{.folder = fs::directory_iterator(state / "recovery")->path(), .note = {}};
        CHECK(read_family(left.family()).name == "found");
        CHECK(parse_recovery_note(content(left.note_file()), "NOTE").name == "found");
    }
}

TEST_CASE("a document is autosaved once it rests, not while it is dragged, and no more once it is undone") {
    const ScratchFolder state;
    Document document(*family_called("begun"));
    for (const auto& [is_dragging, rests, expected] :
         {std::tuple(false, 0.5, 0U), std::tuple(true, 5.0, 0U), std::tuple(false, 5.0, 1U)}) {
        CAPTURE(is_dragging);
        CAPTURE(rests);
        fs::remove_all(state / "recovery");
        {
            DocumentRecovery recovery(state.path(), document);
            document.edit("Rename", *family_called("changed"));
            recovery.look_after(document, is_dragging, 1);
            recovery.look_after(document, is_dragging, 1 + rests);
            document.undo();
        }
        CHECK(folders_in(state / "recovery") == expected);
    }
    fs::remove_all(state / "recovery");
    {
        DocumentRecovery recovery(state.path(), document);
        document.edit("Rename", *family_called("changed"));
        recovery.look_after(document, false, 1);
        recovery.look_after(document, false, 5);
        document.undo();
        recovery.look_after(document, false, 6);
        recovery.look_after(document, false, 10);
    }
    CHECK(folders_in(state / "recovery") == 0);
}

TEST_CASE("an autosave has the family's own time source, not that of one run") {
    for (const bool is_at_once : {false, true}) {
        CAPTURE(is_at_once);
        const ScratchFolder state;
        Family family = sample_family();
        family.path = DomainPath({{0, {-1, -1}}, {4, {1, 1}}});
        Document document(family);
        document.drive_in_this_run(TimeSource::path);
        Family renamed = document.family();
        renamed.name = "renamed";
        {
            DocumentRecovery recovery(state.path(), document);
            document.edit("Rename", renamed);
            if (is_at_once) recovery.keep(document);
            recovery.look_after(document, false, 1);
            recovery.look_after(document, false, 5);
        }
        REQUIRE(folders_in(state / "recovery") == 1);
        const Recovery left{.folder = fs::directory_iterator(state / "recovery")->path(), .note = {}};
        CHECK(read_family(left.family()).name == "renamed");
        CHECK(read_family(left.family()).time_source == TimeSource::keys);
    }
}

TEST_CASE("recoveries are offered one after the other as they are discarded") {
    const ScratchFolder state;
    put_abandoned(state.path(), "4194305-1", "older", 1);
    put_abandoned(state.path(), "4194305-2", "newer", 2);
    DocumentRecovery recovery(state.path(), Document(*family_called("begun")));
    REQUIRE(recovery.offered());
    CHECK(question_about(recovery.offered()->note).text == "Recover newer?");
    recovery.discard_offered();
    REQUIRE(recovery.offered());
    CHECK(recovery.offered()->note.name == "older");
    CHECK(folders_in(state / "recovery") == 1);
    recovery.discard_offered();
    CHECK(recovery.offered() == nullptr);
    CHECK(folders_in(state / "recovery") == 0);
}

TEST_CASE("another user cannot look into a recovery") {
    const ScratchFolder state;
    const Recovery own = make_recovery(state.path());
    CHECK((fs::status(own.folder).permissions() & fs::perms::mask) == fs::perms::owner_all);
}
