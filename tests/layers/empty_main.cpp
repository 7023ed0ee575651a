// A program of nothing but the libraries it is linked with.
int main() {
    return 0;
}
